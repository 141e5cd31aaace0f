package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*
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

/** The display name of [thing], such as `wall 3, 40 cm`. */
@Composable
internal fun elementText(world: World, thing: ElementRef): String {
    val piece = world.piece(thing) ?: return ""
    val number = thing.number + 1
    return when (piece) {
        is Element.OfRobot -> stringResource(Res.string.worldedit_robot_named, piece.robot.name)

        is Element.OfWall -> {
            val length = length(piece.wall.to.x - piece.wall.from.x, piece.wall.to.y - piece.wall.from.y)
            stringResource(Res.string.worldedit_wall_numbered, number, written(round(length * 10) / 10))
        }

        is Element.OfGoal -> piece.goal.says ?: stringResource(goalTitle(piece.goal.condition))

        is Element.OfBarrier, is Element.OfBlock, is Element.OfMark, is Element.OfLamp, is Element.OfStroke -> {
            piece.name ?: stringResource(Res.string.worldedit_numbered, stringResource(kindOf(piece)), number)
        }
    }
}

/** The selection in words. */
@Composable
internal fun selectionText(editing: WorldEditing): String {
    val only = editing.only
    return when {
        only != null -> stringResource(Res.string.worldedit_one_chosen, elementText(editing.world, only))
        editing.selection.isEmpty() -> stringResource(Res.string.worldedit_none_chosen)
        else -> stringResource(Res.string.worldedit_several_chosen, editing.selection.size)
    }
}

/** The kind of an element in one or two words. */
internal fun kindOf(piece: Element): StringResource = when (piece) {
    is Element.OfRobot -> Res.string.worldedit_item_robot
    is Element.OfWall -> Res.string.worldedit_item_wall

    is Element.OfBarrier -> when (piece.barrier.shape) {
        is Shape.Rectangle -> Res.string.worldedit_item_box
        is Shape.Circle -> Res.string.worldedit_item_column
        is Shape.Polygon -> Res.string.worldedit_item_cornered_barrier
    }

    is Element.OfBlock -> Res.string.worldedit_item_block

    is Element.OfMark -> when (val figure = piece.mark.figure) {
        is MarkFigure.Line -> Res.string.worldedit_item_line
        is MarkFigure.GreyMap -> Res.string.worldedit_grey_map

        is MarkFigure.Area -> {
            if (figure.shape is Shape.Circle) Res.string.worldedit_item_dot else Res.string.worldedit_item_area
        }
    }

    is Element.OfLamp -> Res.string.worldedit_item_lamp
    is Element.OfStroke -> Res.string.worldedit_item_template_line
    is Element.OfGoal -> goalTitle(piece.goal.condition)
}

internal fun colourWord(colour: RobotColour): StringResource = when (colour) {
    RobotColour.YELLOW -> Res.string.worldedit_yellow
    RobotColour.RED -> Res.string.worldedit_red
    RobotColour.BLUE -> Res.string.worldedit_blue
    RobotColour.GREEN -> Res.string.worldedit_green
    RobotColour.ORANGE -> Res.string.worldedit_orange
    RobotColour.PURPLE -> Res.string.worldedit_purple
    RobotColour.WHITE -> Res.string.worldedit_white
    RobotColour.BLACK -> Res.string.worldedit_black
}
