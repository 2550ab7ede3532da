# Cross-parameterizes one pair of meshes: from two meshes and two sketches to the compatible mesh.
#
#   make -f pipelines/cross-parameterize.mk SOURCE=a.ply SOURCE_SKETCH=a.sketch.json \
#                                           TARGET=b.ply TARGET_SKETCH=b.sketch.json OUT=folder
#
# Meshes are PLY, or OBJ, OFF, STL, which convert-mesh reads. Without sketches each mesh is one part.
# OUT receives every intermediate document (source.segment, source.hull, source.hullmap, the same for target, crossmap,
# reconstructed, critical), each as .ply and .json; the result compatible.ply and compatible.json; its figures in
# measure.json. What is there and up to date is not made again; -j runs independent stages side by side.
# Options of single stages: see stages.mk.
include $(dir $(lastword $(MAKEFILE_LIST)))stages.mk

$(call check_input,SOURCE,mesh)
$(call check_input,TARGET,mesh)
$(if $(SOURCE_SKETCH),$(call check_input,SOURCE_SKETCH,sketch.json))
$(if $(TARGET_SKETCH),$(call check_input,TARGET_SKETCH,sketch.json))
$(call check_path,OUT)
$(if $(OUT),,$(error OUT is not given; say OUT=folder for the results))

.PHONY: result
result: $(call document,$(OUT)/compatible) $(OUT)/measure.json

$(eval $(call model_rules,$(OUT)/source,$(SOURCE),$(SOURCE_SKETCH)))
$(eval $(call model_rules,$(OUT)/target,$(TARGET),$(TARGET_SKETCH)))
$(eval $(call pair_rules,$(OUT),$(OUT)/source,$(OUT)/target))
