package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.world.MarkFigure
import robotran.world.RobotColour
import robotran.world.World
import robotran.world.geometry.Shape
import robotran.world.geometry.length
import robotran.worldediting.Element
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEditing
import robotran.worldediting.name
import robotran.worldediting.piece
import robotran.worldediting.written
import kotlin.math.round

/** The display name of [ref], such as `wall 3, 40 cm`. */
@Composable
internal fun elementText(world: World, ref: ElementRef): String {
    val piece = world.piece(ref) ?: return ""
    val number = ref.number + 1
    return when (piece) {
        is Element.OfRobot -> WorldEditorTexts.robotNamed(spoken, piece.robot.name)

        is Element.OfWall -> {
            val length = length(piece.wall.to.x - piece.wall.from.x, piece.wall.to.y - piece.wall.from.y)
            WorldEditorTexts.wallNumbered(spoken, number, written(round(length * 10) / 10))
        }

        is Element.OfGoal -> piece.goal.says ?: goalTitle(piece.goal.condition)(spoken)

        is Element.OfBarrier, is Element.OfBlock, is Element.OfMark, is Element.OfLamp, is Element.OfStroke -> {
            piece.name ?: WorldEditorTexts.numbered(spoken, kindOf(piece)(spoken), number)
        }
    }
}

/** The selection in words. */
@Composable
internal fun selectionText(editing: WorldEditing): String {
    val only = editing.only
    return when {
        only != null -> WorldEditorTexts.oneChosen(spoken, elementText(editing.world, only))
        editing.selection.isEmpty() -> WorldEditorTexts.noneChosen(spoken)
        else -> WorldEditorTexts.severalChosen(spoken, editing.selection.size)
    }
}

/** The kind of an element in one or two words. */
internal fun kindOf(element: Element): Label = when (element) {
    is Element.OfRobot -> WorldEditorTexts::itemRobot
    is Element.OfWall -> WorldEditorTexts::itemWall

    is Element.OfBarrier -> when (element.barrier.shape) {
        is Shape.Rectangle -> WorldEditorTexts::itemBox
        is Shape.Circle -> WorldEditorTexts::itemColumn
        is Shape.Polygon -> WorldEditorTexts::itemCorneredBarrier
    }

    is Element.OfBlock -> WorldEditorTexts::itemBlock

    is Element.OfMark -> when (val figure = element.mark.figure) {
        is MarkFigure.Line -> WorldEditorTexts::itemLine
        is MarkFigure.GreyMap -> WorldEditorTexts::greyMap

        is MarkFigure.Area -> {
            if (figure.shape is Shape.Circle) WorldEditorTexts::itemDot else WorldEditorTexts::itemArea
        }
    }

    is Element.OfLamp -> WorldEditorTexts::itemLamp
    is Element.OfStroke -> WorldEditorTexts::itemTemplateLine
    is Element.OfGoal -> goalTitle(element.goal.condition)
}

internal fun colourWord(colour: RobotColour): Label = when (colour) {
    RobotColour.YELLOW -> WorldEditorTexts::yellow
    RobotColour.RED -> WorldEditorTexts::red
    RobotColour.BLUE -> WorldEditorTexts::blue
    RobotColour.GREEN -> WorldEditorTexts::green
    RobotColour.ORANGE -> WorldEditorTexts::orange
    RobotColour.PURPLE -> WorldEditorTexts::purple
    RobotColour.WHITE -> WorldEditorTexts::white
    RobotColour.BLACK -> WorldEditorTexts::black
}
