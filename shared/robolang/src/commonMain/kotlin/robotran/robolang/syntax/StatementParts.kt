package robotran.robolang.syntax

import robotran.robolang.words.ValueUse

/** The target of an assignment. */
internal sealed interface AssignTarget {
    data class Variable(val name: Name) : AssignTarget

    /** One element of a list, counted from 0. */
    data class ListElement(val list: Name, val index: Expression) : AssignTarget
}

/** A command to one motor. */
internal sealed interface MotorCommand {
    data object Forward : MotorCommand

    data object Backward : MotorCommand

    /** Brakes. */
    data object Stop : MotorCommand

    /** Coasts without current. */
    data object Float : MotorCommand

    /** 0..7, for this motor from now on. */
    data class Power(val power: Expression) : MotorCommand
}

internal enum class PowerSide { BOTH, LEFT, RIGHT }

internal enum class MoveDirection { FORWARD, BACKWARD }

internal enum class TurnDirection { LEFT, RIGHT }

internal enum class PenPosition { DOWN, UP }

internal enum class TimeUnit(val use: ValueUse) { SECONDS(ValueUse.SECONDS), MILLISECONDS(ValueUse.MILLISECONDS) }
