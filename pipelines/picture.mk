# A picture of every stage of a pair that cross-parameterize.mk made in OUT: OUT/picture.png, rendered by POV-Ray.
#
#   make -f pipelines/picture.mk OUT=folder
#
# For a pair of batch.mk, say where its models are: SOURCE_MODEL=out/models/cat TARGET_MODEL=out/models/lion.
# SOURCE_VIEW and TARGET_VIEW are "x,y,z,x,y,z", the direction to the eye and the upward direction, or "auto".
include $(dir $(lastword $(MAKEFILE_LIST)))stages.mk

SOURCE_MODEL ?= $(OUT)/source
TARGET_MODEL ?= $(OUT)/target
SOURCE_VIEW ?= auto
TARGET_VIEW ?= auto
PICTURE_WIDTH ?= 1800
$(call check_path,OUT)
$(if $(OUT),,$(error OUT is not given; say OUT=folder of a pair))

model_panels = mesh=$(1).segment.ply $(1).segment.ply $(1).hull.ply $(1).hullmap.ply
panels := $(call model_panels,$(SOURCE_MODEL)) $(OUT)/crossmap.ply $(call model_panels,$(TARGET_MODEL)) $(OUT)/compatible.ply
views := $(if $(filter-out auto,$(SOURCE_VIEW) $(TARGET_VIEW)),$(foreach i,1 2 3 4,$(SOURCE_VIEW)) $(foreach \
  i,1 2 3 4 5 6,$(TARGET_VIEW)))

$(OUT)/picture.png: $(OUT)/picture.pov
	$(call povray,$(OUT),picture)

$(OUT)/picture.pov: $(sort $(patsubst mesh=%,%,$(panels))) $(call settings,$(OUT)/.settings/picture,$(views) $(PICTURE_WIDTH))
	'$(PARTWISE_BIN)/picture' $(panels) --columns 5 --width $(PICTURE_WIDTH) $(addprefix --view=,$(views)) --force -o $@
