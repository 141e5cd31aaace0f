package robotran.worldediting

import robotran.world.Barrier
import robotran.world.Goal
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MovableBlock
import robotran.world.RobotPlacement
import robotran.world.Wall
import robotran.world.geometry.Point

/** The value of an [ElementRef], independent of its world: it can be copied, changed and added to a world. */
sealed interface Element {
    data class OfRobot(val robot: RobotPlacement) : Element

    data class OfWall(val wall: Wall) : Element

    data class OfBarrier(val barrier: Barrier) : Element

    data class OfBlock(val block: MovableBlock) : Element

    data class OfMark(val mark: Mark) : Element

    data class OfLamp(val lamp: Lamp) : Element

    /** A line of the template. */
    data class OfStroke(val points: List<Point>) : Element

    data class OfGoal(val goal: Goal) : Element
}

val Element.kind: ElementKind
    get() = when (this) {
        is Element.OfRobot -> ElementKind.ROBOT
        is Element.OfWall -> ElementKind.WALL
        is Element.OfBarrier -> ElementKind.BARRIER
        is Element.OfBlock -> ElementKind.BLOCK
        is Element.OfMark -> ElementKind.MARK
        is Element.OfLamp -> ElementKind.LAMP
        is Element.OfStroke -> ElementKind.STROKE
        is Element.OfGoal -> ElementKind.GOAL
    }

/** null if it has no name. */
val Element.name: String?
    get() = when (this) {
        is Element.OfRobot -> robot.name
        is Element.OfBarrier -> barrier.name
        is Element.OfBlock -> block.name
        is Element.OfMark -> mark.name
        is Element.OfLamp -> lamp.name
        is Element.OfWall, is Element.OfStroke, is Element.OfGoal -> null
    }

/** The same with another name, if it can have one; a robot always has one. */
fun Element.named(name: String?): Element = when (this) {
    is Element.OfRobot -> if (name == null) this else copy(robot.copy(name = name))
    is Element.OfBarrier -> copy(barrier.copy(name = name))
    is Element.OfBlock -> copy(block.copy(name = name))
    is Element.OfMark -> copy(mark.copy(name = name))
    is Element.OfLamp -> copy(lamp.copy(name = name))
    is Element.OfWall, is Element.OfStroke, is Element.OfGoal -> this
}
