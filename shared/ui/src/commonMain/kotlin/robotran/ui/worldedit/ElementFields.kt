package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import robotran.ui.language.spoken
import robotran.ui.settings.SwitchRow
import robotran.ui.texts.WorldEditorTexts
import robotran.world.Block
import robotran.world.Lamp
import robotran.world.MarkFigure
import robotran.world.WorldLimits
import robotran.worldediting.Edit
import robotran.worldediting.EditError
import robotran.worldediting.Element
import robotran.worldediting.ElementRef
import robotran.worldediting.name
import robotran.worldediting.named

/** All properties of one element. */
@Composable
internal fun ElementFields(making: EditorScope, thing: ElementRef, piece: Element) {
    when (piece) {
        is Element.OfRobot -> RobotFields(making, thing, piece)

        is Element.OfWall -> {
            FormFields(making, thing, piece)
            ThicknessField(making, piece.wall.thickness) {
                making.change(thing, Element.OfWall(piece.wall.copy(thickness = it)))
            }
        }

        is Element.OfBarrier -> {
            NameField(making, thing, piece)
            FormFields(making, thing, piece)
        }

        is Element.OfBlock -> {
            NameField(making, thing, piece)
            BlockFields(making, piece.block) { making.change(thing, Element.OfBlock(it)) }
            FormFields(making, thing, piece)
        }

        is Element.OfMark -> MarkFields(making, thing, piece)
        is Element.OfLamp -> LampFields(making, thing, piece)
        is Element.OfStroke -> FormFields(making, thing, piece)
        is Element.OfGoal -> GoalFields(making, thing, piece)
    }
}

/** A name is needed only if a goal refers to the element. */
@Composable
internal fun NameField(making: EditorScope, thing: ElementRef, piece: Element) {
    val taken = (making.editing.error as? EditError.NameTaken)?.let { editErrorText(it) }
    TextRow(
        WorldEditorTexts.name(spoken),
        piece.name.orEmpty(),
        WorldLimits.MAXIMUM_NAME_CHARACTERS,
        "field-name",
        { making.change(thing, piece.named(it.takeIf(String::isNotBlank))) },
        making::settle,
        mayBeBlank = piece !is Element.OfRobot,
        hint = WorldEditorTexts.noName(spoken),
        error = taken,
    )
}

@Composable
private fun BlockFields(making: EditorScope, block: Block, onChange: (Block) -> Unit) {
    NumberRow(
        WorldEditorTexts.mass(spoken),
        block.mass,
        WorldLimits.MINIMUM_MASS..WorldLimits.MAXIMUM_MASS,
        "field-mass",
        { onChange(block.copy(mass = it)) },
        making::settle,
        step = 0.05,
        unit = "kg",
        slider = 0.05f..2f,
    )
    NumberRow(
        WorldEditorTexts.friction(spoken),
        block.friction,
        0.0..WorldLimits.MAXIMUM_FRICTION,
        "field-friction",
        { onChange(block.copy(friction = it)) },
        making::settle,
        step = 0.05,
        slider = 0f..1.5f,
    )
    Remark(WorldEditorTexts.frictionHelp(spoken))
}

@Composable
private fun MarkFields(making: EditorScope, thing: ElementRef, piece: Element.OfMark) {
    val mark = piece.mark
    NameField(making, thing, piece)
    when (val figure = mark.figure) {
        is MarkFigure.GreyMap -> Remark(WorldEditorTexts.greyMapHelp(spoken))

        is MarkFigure.Area -> {
            ShadeFields(making, mark.shade) { making.change(thing, Element.OfMark(mark.copy(shade = it))) }
        }

        is MarkFigure.Line -> {
            ShadeFields(making, mark.shade) { making.change(thing, Element.OfMark(mark.copy(shade = it))) }
            ThicknessField(making, figure.width) {
                making.change(thing, Element.OfMark(mark.copy(figure = figure.copy(width = it))))
            }
            SwitchRow(WorldEditorTexts.closed(spoken), figure.closed, "field-closed") {
                making.changeAtOnce(thing, Element.OfMark(mark.copy(figure = figure.copy(closed = it))))
            }
        }
    }
    FormFields(making, thing, piece)
}

@Composable
private fun ThicknessField(making: EditorScope, value: Double, onChange: (Double) -> Unit) = NumberRow(
    WorldEditorTexts.thickness(spoken),
    value,
    WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_WALL_THICKNESS,
    "field-thickness",
    onChange,
    making::settle,
    step = 0.5,
    unit = "cm",
    slider = 0.5f..10f,
)

@Composable
private fun LampFields(making: EditorScope, thing: ElementRef, piece: Element.OfLamp) {
    val lamp = piece.lamp
    val change = { changed: Lamp -> making.change(thing, Element.OfLamp(changed)) }
    NameField(making, thing, piece)
    SwitchRow(WorldEditorTexts.lampOn(spoken), lamp.on, "field-on") {
        making.changeAtOnce(thing, Element.OfLamp(lamp.copy(on = it)))
    }
    SwitchRow(WorldEditorTexts.lampInfrared(spoken), lamp.infrared, "field-infrared") {
        making.changeAtOnce(thing, Element.OfLamp(lamp.copy(infrared = it)))
    }
    NumberRow(
        WorldEditorTexts.brightness(spoken),
        lamp.brightness,
        0.0..WorldLimits.MAXIMUM_BRIGHTNESS,
        "field-brightness",
        { change(lamp.copy(brightness = it)) },
        making::settle,
        step = 0.5,
        slider = 0f..10f,
    )
    NumberRow(
        WorldEditorTexts.cone(spoken),
        lamp.cone,
        WorldLimits.MINIMUM_CONE..Lamp.ALL_ROUND,
        "field-cone",
        { change(lamp.copy(cone = it)) },
        making::settle,
        step = 15.0,
        unit = "°",
        slider = 15f..360f,
    )
    if (lamp.cone < Lamp.ALL_ROUND) {
        AngleField(making, WorldEditorTexts.direction(spoken), lamp.direction) {
            change(lamp.copy(direction = it))
        }
    } else {
        Remark(WorldEditorTexts.coneHelp(spoken))
    }
    FormFields(making, thing, piece)
}

/** Sends an edit as a step of its own. */
internal fun EditorScope.makeAtOnce(edit: Edit) {
    settle()
    make(edit)
    settle()
}
