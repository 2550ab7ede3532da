# Blends three and more models, each with one sketch: one of them lends its connectivity, and is mapped to the others.
#
#   make -f pipelines/blend.mk MODELS=folder NAMES="cow camel triceratops" WEIGHTS=0.5,0.3,0.2 OUT=folder
#
# MODELS, SKETCHES and OUT are as in batch.mk: models and pairs that a batch made in OUT are not made again. The
# connectivity is that of the first name, or CONNECTIVITY=name. OUT/blend.ply is the blend with WEIGHTS, one per name in
# their order (equal shares when not given); OUT/blend.glb goes from each model to the next, and back to the first, in
# FRAMES (49) frames. The models are scaled, turned and moved onto the first of NAMES, so that only their shapes are
# blended; ALIGN=no leaves them as they are. MORPH_FLAGS are further options of morph. `strip` makes OUT/blend.png, all
# with that connectivity, and their blend, side by side (POV-Ray).
CONNECTIVITY ?= $(firstword $(NAMES))
FRAMES ?= 49
PICTURE_WIDTH ?= 1000
morph_options = $(if $(filter no,$(ALIGN)),,--align) $(MORPH_FLAGS)
$(if $(word 2,$(NAMES)),,$(error NAMES="$(NAMES)" are no two models or more; say NAMES="cow camel triceratops"))
$(if $(filter $(CONNECTIVITY),$(NAMES)),,$(error CONNECTIVITY=$(CONNECTIVITY) is none of NAMES="$(NAMES)"))
others := $(filter-out $(CONNECTIVITY),$(NAMES))
override PAIRS := $(foreach name,$(others),$(CONNECTIVITY):$(name))
include $(dir $(lastword $(MAKEFILE_LIST)))batch.mk

pair_of = $(OUT)/$(CONNECTIVITY)-$(1)/compatible
shape_of = $(if $(filter $(CONNECTIVITY),$(1)),source=$(call pair_of,$(firstword $(others))).ply,$(call pair_of,$(1)).ply)
shapes := $(foreach name,$(NAMES),$(call shape_of,$(name)))
compatibles := $(foreach name,$(others),$(call document,$(call pair_of,$(name))))

.DEFAULT_GOAL := blend
.PHONY: blend strip
blend: $(call document,$(OUT)/blend) $(OUT)/blend.glb

$(call document,$(OUT)/blend) &: $(compatibles) $(call settings,$(OUT)/.settings/blend,$(shapes) $(WEIGHTS) $(morph_options))
	'$(PARTWISE_BIN)/morph' $(shapes) $(if $(WEIGHTS),--weights=$(WEIGHTS)) $(morph_options) --force -o $(OUT)/blend.ply
$(OUT)/blend.glb: $(compatibles) $(call settings,$(OUT)/.settings/blend-animation,$(shapes) $(FRAMES) $(morph_options))
	'$(PARTWISE_BIN)/morph' $(shapes) $(firstword $(shapes)) --frames=$(FRAMES) $(morph_options) --force -o $@

strip: $(OUT)/blend.png
$(OUT)/blend.png: $(OUT)/blend.pov
	$(call povray,$(OUT),blend)
$(OUT)/blend.pov: $(call document,$(OUT)/blend) $(call settings,$(OUT)/.settings/strip,$(shapes) $(PICTURE_WIDTH))
	'$(PARTWISE_BIN)/picture' $(shapes) $(OUT)/blend.ply $(foreach name,$(NAMES),--caption=$(name)) \
	  '--caption=$(WEIGHTS)' --columns $(words $(NAMES) blend) --width $(PICTURE_WIDTH) --force -o $@
