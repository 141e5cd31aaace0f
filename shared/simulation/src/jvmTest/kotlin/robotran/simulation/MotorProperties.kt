package robotran.simulation

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.simulation.config.SimulationLimits
import robotran.simulation.robot.RcxMotor
import robotran.world.geometry.distance
import robotran.world.robot.RobotParameters

class MotorProperties :
    StringSpec({
        fun described(mode: MotorMode, power: Int) = MotorState(MotorPort.A, mode, power)

        fun distance(mode: MotorMode, power: Int, milliseconds: Int, brakingPower: Int): Double {
            val motor = RcxMotor(RobotParameters.PENBOT)

            fun way(command: MotorState): Double {
                motor.tick(command)
                return motor.speed * SimulationLimits.TICK_SECONDS
            }
            val driven = (1..milliseconds).sumOf { way(described(mode, power)) }
            return driven + (1..2000).sumOf { way(described(MotorMode.BRAKE, brakingPower)) }
        }

        "a motor drives as far as it is told to, however hard it brakes" {
            checkAll(Arb.int(0..5000), Arb.int(0..7), Arb.int(0..7)) { milliseconds, power, brakingPower ->
                val expected = RcxMotor(RobotParameters.PENBOT).drivenSpeed(power) * milliseconds / 1000
                distance(MotorMode.FORWARD, power, milliseconds, brakingPower) shouldBe (expected plusOrMinus 1e-6)
                distance(MotorMode.BACKWARD, power, milliseconds, brakingPower) shouldBe (-expected plusOrMinus 1e-6)
            }
        }
    })
