package robotran.worldediting

import robotran.world.Barrier
import robotran.world.Block
import robotran.world.Goal
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.RobotPlace
import robotran.world.Wall
import robotran.world.geometry.Point

/** What a [Thing] is like, apart from the world it is in: it can be copied, changed and put into a world. */
sealed interface Piece {
    data class OfRobot(val robot: RobotPlace) : Piece

    data class OfWall(val wall: Wall) : Piece

    data class OfBarrier(val barrier: Barrier) : Piece

    data class OfBlock(val block: Block) : Piece

    data class OfMark(val mark: Mark) : Piece

    data class OfLamp(val lamp: Lamp) : Piece

    /** A line of the drawing that is to be traced. */
    data class OfStroke(val points: List<Point>) : Piece

    data class OfGoal(val goal: Goal) : Piece
}

/** The kind of thing that this makes in a world. */
val Piece.kind: ThingKind
    get() = when (this) {
        is Piece.OfRobot -> ThingKind.ROBOT
        is Piece.OfWall -> ThingKind.WALL
        is Piece.OfBarrier -> ThingKind.BARRIER
        is Piece.OfBlock -> ThingKind.BLOCK
        is Piece.OfMark -> ThingKind.MARK
        is Piece.OfLamp -> ThingKind.LAMP
        is Piece.OfStroke -> ThingKind.STROKE
        is Piece.OfGoal -> ThingKind.GOAL
    }

/** What people and goals know it by; null if it has no name. */
val Piece.name: String?
    get() = when (this) {
        is Piece.OfRobot -> robot.name
        is Piece.OfBarrier -> barrier.name
        is Piece.OfBlock -> block.name
        is Piece.OfMark -> mark.name
        is Piece.OfLamp -> lamp.name
        is Piece.OfWall, is Piece.OfStroke, is Piece.OfGoal -> null
    }

/** The same with another name, where this can have one; a robot always keeps one. */
fun Piece.named(name: String?): Piece = when (this) {
    is Piece.OfRobot -> if (name == null) this else copy(robot.copy(name = name))
    is Piece.OfBarrier -> copy(barrier.copy(name = name))
    is Piece.OfBlock -> copy(block.copy(name = name))
    is Piece.OfMark -> copy(mark.copy(name = name))
    is Piece.OfLamp -> copy(lamp.copy(name = name))
    is Piece.OfWall, is Piece.OfStroke, is Piece.OfGoal -> this
}
