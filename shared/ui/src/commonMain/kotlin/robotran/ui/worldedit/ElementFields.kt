package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.world.Lamp
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.WorldLimits
import robotran.worldediting.Element
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import robotran.worldediting.WorldEditError
import robotran.worldediting.name
import robotran.worldediting.named

/** All properties of one element. */
@Composable
internal fun ElementFields(editor: EditorScope, ref: ElementRef, element: Element) {
    when (element) {
        is Element.OfRobot -> RobotFields(editor, ref, element)

        is Element.OfWall -> {
            FormFields(editor, ref, element)
            ThicknessField(editor, element.wall.thickness) {
                editor.change(ref, Element.OfWall(element.wall.copy(thickness = it)))
            }
        }

        is Element.OfBarrier -> {
            NameField(editor, ref, element)
            FormFields(editor, ref, element)
        }

        is Element.OfBlock -> {
            NameField(editor, ref, element)
            BlockFields(editor, element.block) { editor.change(ref, Element.OfBlock(it)) }
            FormFields(editor, ref, element)
        }

        is Element.OfMark -> MarkFields(editor, ref, element)
        is Element.OfLamp -> LampFields(editor, ref, element)
        is Element.OfStroke -> FormFields(editor, ref, element)
        is Element.OfGoal -> GoalFields(editor, ref, element)
    }
}

/** A name is needed only if a goal refers to the element. */
@Composable
internal fun NameField(editor: EditorScope, ref: ElementRef, element: Element) {
    val taken = (editor.editing.error as? WorldEditError.NameTaken)?.let { editErrorText(it) }
    TextRow(
        WorldEditorTexts.name(spoken),
        element.name.orEmpty(),
        WorldLimits.MAXIMUM_NAME_CHARACTERS,
        "field-name",
        { editor.change(ref, element.named(it.takeIf(String::isNotBlank))) },
        editor::settle,
        mayBeBlank = element !is Element.OfRobot,
        hint = WorldEditorTexts.noName(spoken),
        error = taken,
    )
}

@Composable
private fun BlockFields(editor: EditorScope, block: MovableBlock, onChange: (MovableBlock) -> Unit) {
    NumberRow(
        WorldEditorTexts.mass(spoken),
        block.mass,
        WorldLimits.MINIMUM_MASS..WorldLimits.MAXIMUM_MASS,
        "field-mass",
        { onChange(block.copy(mass = it)) },
        editor::settle,
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
        editor::settle,
        step = 0.05,
        slider = 0f..1.5f,
    )
    HelpText(WorldEditorTexts.frictionHelp(spoken))
}

@Composable
private fun MarkFields(editor: EditorScope, ref: ElementRef, piece: Element.OfMark) {
    val mark = piece.mark
    NameField(editor, ref, piece)
    when (val figure = mark.figure) {
        is MarkFigure.GreyMap -> HelpText(WorldEditorTexts.greyMapHelp(spoken))

        is MarkFigure.Area -> {
            ShadeFields(editor, mark.shade) { editor.change(ref, Element.OfMark(mark.copy(shade = it))) }
        }

        is MarkFigure.Line -> {
            ShadeFields(editor, mark.shade) { editor.change(ref, Element.OfMark(mark.copy(shade = it))) }
            ThicknessField(editor, figure.width) {
                editor.change(ref, Element.OfMark(mark.copy(figure = figure.copy(width = it))))
            }
            SwitchRow(WorldEditorTexts.closed(spoken), figure.closed, "field-closed") {
                editor.changeAtOnce(ref, Element.OfMark(mark.copy(figure = figure.copy(closed = it))))
            }
        }
    }
    FormFields(editor, ref, piece)
}

@Composable
private fun ThicknessField(editor: EditorScope, value: Double, onChange: (Double) -> Unit) = NumberRow(
    WorldEditorTexts.thickness(spoken),
    value,
    WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_WALL_THICKNESS,
    "field-thickness",
    onChange,
    editor::settle,
    step = 0.5,
    unit = "cm",
    slider = 0.5f..10f,
)

@Composable
private fun LampFields(editor: EditorScope, ref: ElementRef, piece: Element.OfLamp) {
    val lamp = piece.lamp
    val change = { changed: Lamp -> editor.change(ref, Element.OfLamp(changed)) }
    NameField(editor, ref, piece)
    SwitchRow(WorldEditorTexts.lampOn(spoken), lamp.on, "field-on") {
        editor.changeAtOnce(ref, Element.OfLamp(lamp.copy(on = it)))
    }
    SwitchRow(WorldEditorTexts.lampInfrared(spoken), lamp.infrared, "field-infrared") {
        editor.changeAtOnce(ref, Element.OfLamp(lamp.copy(infrared = it)))
    }
    NumberRow(
        WorldEditorTexts.brightness(spoken),
        lamp.brightness,
        0.0..WorldLimits.MAXIMUM_BRIGHTNESS,
        "field-brightness",
        { change(lamp.copy(brightness = it)) },
        editor::settle,
        step = 0.5,
        slider = 0f..10f,
    )
    NumberRow(
        WorldEditorTexts.cone(spoken),
        lamp.cone,
        WorldLimits.MINIMUM_CONE..Lamp.ALL_ROUND,
        "field-cone",
        { change(lamp.copy(cone = it)) },
        editor::settle,
        step = 15.0,
        unit = "°",
        slider = 15f..360f,
    )
    if (lamp.cone < Lamp.ALL_ROUND) {
        AngleField(editor, WorldEditorTexts.direction(spoken), lamp.direction) {
            change(lamp.copy(direction = it))
        }
    } else {
        HelpText(WorldEditorTexts.coneHelp(spoken))
    }
    FormFields(editor, ref, piece)
}

/** Sends an edit as a step of its own. */
internal fun EditorScope.makeAtOnce(edit: WorldEdit) {
    settle()
    make(edit)
    settle()
}
