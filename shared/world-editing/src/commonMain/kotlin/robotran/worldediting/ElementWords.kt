package robotran.worldediting

import robotran.editing.Words
import robotran.editing.WorldEditorTexts
import robotran.editing.written
import robotran.world.GoalCondition
import robotran.world.MarkFigure
import robotran.world.RobotColour
import robotran.world.World
import robotran.world.geometry.Shape
import robotran.world.geometry.length
import kotlin.math.round

/** The display name of [ref], such as `wall 3, 40 cm`. */
fun elementWords(world: World, ref: ElementRef): Words = { language ->
    val number = ref.number + 1
    when (val piece = world.piece(ref)) {
        null -> ""
        is Element.OfRobot -> WorldEditorTexts.robotNamed(language, piece.robot.name)

        is Element.OfWall -> {
            val length = length(piece.wall.to.x - piece.wall.from.x, piece.wall.to.y - piece.wall.from.y)
            WorldEditorTexts.wallNumbered(language, number, written(round(length * 10) / 10))
        }

        is Element.OfGoal -> piece.goal.says ?: goalTitle(piece.goal.condition)(language)

        is Element.OfBarrier, is Element.OfBlock, is Element.OfMark, is Element.OfLamp, is Element.OfStroke -> {
            piece.name ?: WorldEditorTexts.numbered(language, kindOf(piece)(language), number)
        }
    }
}

/** The kind of an element in one or two words. */
fun kindOf(element: Element): Words = when (element) {
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

/** The short title of a goal. */
fun goalTitle(condition: GoalCondition): Words = when (condition) {
    is GoalCondition.Reach -> WorldEditorTexts::goalReach
    is GoalCondition.StayOut -> WorldEditorTexts::goalStayOut
    is GoalCondition.StayIn -> WorldEditorTexts::goalStayIn
    is GoalCondition.NeverTouch -> WorldEditorTexts::goalNeverTouch
    is GoalCondition.DrawTemplate -> WorldEditorTexts::goalDrawTemplate
    is GoalCondition.InkLength -> WorldEditorTexts::goalInkLength
    is GoalCondition.FollowLine -> WorldEditorTexts::goalFollowLine
    is GoalCondition.EndWithin -> WorldEditorTexts::goalEndWithin
    is GoalCondition.ShowOnDisplay -> WorldEditorTexts::goalShow
    is GoalCondition.PlaySound -> WorldEditorTexts::goalSound
    is GoalCondition.InOrder -> WorldEditorTexts::goalInOrder
    is GoalCondition.All -> WorldEditorTexts::goalAll
    is GoalCondition.AnyOf -> WorldEditorTexts::goalAnyOf
}

fun colourWord(colour: RobotColour): Words = when (colour) {
    RobotColour.YELLOW -> WorldEditorTexts::yellow
    RobotColour.RED -> WorldEditorTexts::red
    RobotColour.BLUE -> WorldEditorTexts::blue
    RobotColour.GREEN -> WorldEditorTexts::green
    RobotColour.ORANGE -> WorldEditorTexts::orange
    RobotColour.PURPLE -> WorldEditorTexts::purple
    RobotColour.WHITE -> WorldEditorTexts::white
    RobotColour.BLACK -> WorldEditorTexts::black
}
