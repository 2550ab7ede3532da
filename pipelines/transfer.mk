# Transfers poses and properties between the two models of a pair, from the source to the target, or with REVERSE=yes
# the other way round.
#
#   make -f pipelines/transfer.mk OUT=folder POSES="a-1.ply a-2.ply" ATTRIBUTES=a-painted.ply
#
# POSES are meshes with the vertices and facets of the source (of the target with REVERSE=yes): RESULTS/poses/NAME.ply
# for each, and RESULTS/poses.glb with all. ATTRIBUTES is a PLY of the same mesh with colours, labels, texture
# coordinates and so on: RESULTS/attributes.ply. RESULTS is OUT/transfer (OUT/transfer-reverse) unless it is given.
# CORRESPONDENCE=hull takes poses over as the paper does, by facets near each other on the common hulls.
# `strip` makes RESULTS/attributes.png, both models in their colours (POV-Ray). TRANSFER_FLAGS are further options of transfer. SOURCE, SOURCE_SKETCH, TARGET and TARGET_SKETCH make the pair as
# cross-parameterize.mk does; without, it must have been made in OUT.
include $(dir $(lastword $(MAKEFILE_LIST)))$(if $(SOURCE),cross-parameterize,stages).mk

reverse := $(filter yes,$(REVERSE))
RESULTS ?= $(OUT)/transfer$(if $(reverse),-reverse)
$(call check_path,OUT)
$(call check_path,RESULTS)
$(if $(OUT),,$(error OUT is not given; say OUT=folder of a pair))
$(if $(POSES)$(ATTRIBUTES),,$(error nothing to transfer; say POSES="a-1.ply a-2.ply" or ATTRIBUTES=a-painted.ply))
$(if $(ATTRIBUTES),$(call check_input,ATTRIBUTES,mesh.ply))
$(foreach pose,$(POSES),$(if $(wildcard $(pose)),,$(error POSES: there is no file $(pose))))

pose_map := $(OUT)/$(if $(filter hull,$(CORRESPONDENCE)),crossmap,compatible)
transfer_options = $(if $(reverse),--reverse) $(TRANSFER_FLAGS)
transfer_settings = $(call settings,$(RESULTS)/.settings/$(1),$(2) $(CORRESPONDENCE) $(transfer_options))
poses := $(foreach pose,$(POSES),$(call document,$(RESULTS)/poses/$(basename $(notdir $(pose)))))

.DEFAULT_GOAL := transfer
.PHONY: transfer strip
transfer: $(poses) $(if $(POSES),$(RESULTS)/poses.glb) $(if $(ATTRIBUTES),$(call document,$(RESULTS)/attributes))

ifneq ($(strip $(POSES)),)
$(poses) &: $(call document,$(pose_map)) $(POSES) $(call transfer_settings,poses,$(POSES))
	'$(PARTWISE_BIN)/transfer' $(pose_map).ply --poses $(POSES) $(transfer_options) --force -o $(RESULTS)/poses/
$(RESULTS)/poses.glb: $(call document,$(pose_map)) $(POSES) $(call transfer_settings,animation,$(POSES))
	'$(PARTWISE_BIN)/transfer' $(pose_map).ply --poses $(POSES) $(transfer_options) --force -o $@
endif
ifneq ($(strip $(ATTRIBUTES)),)
$(call document,$(RESULTS)/attributes) &: $(call document,$(OUT)/compatible) $(ATTRIBUTES) $(call \
  transfer_settings,attributes,$(ATTRIBUTES))
	'$(PARTWISE_BIN)/transfer' $(OUT)/compatible.ply --attributes $(ATTRIBUTES) $(transfer_options) --force \
	  -o $(RESULTS)/attributes.ply

PICTURE_WIDTH ?= 600
strip: $(RESULTS)/attributes.png
$(RESULTS)/attributes.png: $(RESULTS)/attributes.pov
	$(call povray,$(RESULTS),attributes)
$(RESULTS)/attributes.pov: $(call document,$(RESULTS)/attributes) $(call settings,$(RESULTS)/.settings/strip,$(PICTURE_WIDTH))
	'$(PARTWISE_BIN)/picture' $(ATTRIBUTES) $(RESULTS)/attributes.ply --caption=given --caption=transferred --columns 2 \
	  --width $(PICTURE_WIDTH) --force -o $@
endif
