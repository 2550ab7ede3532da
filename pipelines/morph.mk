# Morphs between the two models of a pair: OUT/morph.glb, an animation that Blender, three.js and other viewers play.
#
#   make -f pipelines/morph.mk SOURCE=a.ply SOURCE_SKETCH=a.sketch.json TARGET=b.ply TARGET_SKETCH=b.sketch.json OUT=folder
#   make -f pipelines/morph.mk OUT=folder            the same for a pair that was made there
#
# `frames` makes OUT/frames/0000.ply and so on instead. FRAMES says how many (25), MORPH_FLAGS what else morph shall
# know. `strip` makes OUT/morph.png, five moments side by side (POV-Ray), seen from VIEW="x,y,z,x,y,z", the direction to
# the eye and the upward direction. The target is scaled, turned and moved onto the source, so that only the shape
# changes; ALIGN=no leaves both where they are. The pair itself is made as by cross-parameterize.mk where it is not up to
# date.
include $(dir $(lastword $(MAKEFILE_LIST)))$(if $(SOURCE),cross-parameterize,stages).mk

FRAMES ?= 25
PICTURE_WIDTH ?= 1000
VIEW ?= auto
blend_options = $(if $(filter no,$(ALIGN)),,--align) $(MORPH_FLAGS)
morph_options = --frames=$(FRAMES) $(blend_options)
$(call check_path,OUT)
$(if $(OUT),,$(error OUT is not given; say OUT=folder of a pair))

.DEFAULT_GOAL := morph
.PHONY: morph frames strip
morph: $(OUT)/morph.glb

$(OUT)/morph.glb: $(call document,$(OUT)/compatible) $(call settings,$(OUT)/.settings/morph,$(morph_options))
	'$(PARTWISE_BIN)/morph' $< $(morph_options) --force -o $@

strip: $(OUT)/morph.png
moments := 0 0.25 0.5 0.75 1
$(OUT)/morph.png: $(OUT)/morph.pov
	$(call povray,$(OUT),morph)
$(OUT)/morph.pov: $(call document,$(OUT)/compatible) $(call \
  settings,$(OUT)/.settings/strip,$(blend_options) $(PICTURE_WIDTH) $(VIEW))
	rm -rf '$(OUT)/strip'
	'$(PARTWISE_BIN)/morph' $< $(foreach moment,$(moments),--at=$(moment)) $(blend_options) -o $(OUT)/strip/
	'$(PARTWISE_BIN)/picture' $(foreach i,0 1 2 3 4,$(OUT)/strip/000$(i).ply) $(foreach \
	  moment,$(moments),--caption=$(moment)) --view=$(VIEW) --columns 5 --width $(PICTURE_WIDTH) --force -o $@

# Frames of an earlier run may be more.
frames: $(call document,$(OUT)/compatible)
	rm -rf '$(OUT)/frames'
	'$(PARTWISE_BIN)/morph' $< $(morph_options) -o $(OUT)/frames/
