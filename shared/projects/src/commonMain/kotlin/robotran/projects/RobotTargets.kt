package robotran.projects

import robotran.brick.kind.BrickKind
import robotran.brick.kind.WheelTrim
import robotran.hub.model.HubModel
import robotran.microbit.model.MicrobitModel
import robotran.robolang.robot.RobotTarget
import robotran.simulation.hub.hubSensors
import robotran.simulation.microbit.buggyWiring
import robotran.simulation.microbit.microbitSensors
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.robot.RobotParameters

/** What the compiler must know of this robot. */
val RobotDescription.target: RobotTarget
    get() = when (brick) {
        BrickKind.RCX -> RobotParameters.of(this).let {
            RobotTarget.Rcx(
                it.millisecondsPerCentimetre,
                it.millisecondsPerDegree,
                drive.left,
                drive.right,
                pen?.motor,
                drive.reversed,
            )
        }

        BrickKind.NXT -> RobotTarget.Nxt(
            drive.wheelDiameter / drive.gear,
            drive.track,
            drive.left,
            drive.right,
            pen?.motor,
            drive.reversed,
        )

        BrickKind.SPIKE_PRIME, BrickKind.SPIKE_ESSENTIAL, BrickKind.TECHNIC_HUB, BrickKind.EV3, BrickKind.NXT_PYBRICKS,
        -> RobotTarget.Hub(
            checkNotNull(HubModel.of(brick)),
            MILLIMETRES * drive.wheelDiameter / drive.gear,
            MILLIMETRES * drive.track,
            drive.left,
            drive.right,
            pen?.motor,
            drive.reversed,
            hubSensors,
        )

        BrickKind.MICROBIT, BrickKind.MICROBIT_V1 -> RobotParameters.of(this).let {
            RobotTarget.Microbit(
                checkNotNull(MicrobitModel.of(brick)),
                checkNotNull(buggyWiring),
                it.millisecondsPerCentimetre,
                it.millisecondsPerDegree,
                drive.left,
                drive.right,
                pen?.motor,
                drive.reversed,
                buggy?.trim ?: WheelTrim.NONE,
                microbitSensors,
            )
        }
    }

private const val MILLIMETRES = 10

/** What the compiler must know of the penbot with the [BrickKind.default]. */
val PENBOT_TARGET: RobotTarget = BrickKind.default.penbotTarget

/** What the compiler must know of the penbot with a brick of this kind. */
val BrickKind.penbotTarget: RobotTarget
    get() = ReadyRobots.defaultOf(this).target
