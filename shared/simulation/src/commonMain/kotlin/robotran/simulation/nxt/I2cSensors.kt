package robotran.simulation.nxt

import robotran.brick.sensors.SensorKind
import robotran.nxt.hardware.Clock
import robotran.nxt.hardware.I2cDevice
import robotran.rcxrom.infrared.InfraredAir
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.robot.SimulatedRobot
import robotran.simulation.robot.Thermometer
import robotran.world.SensorPart

/** Makes the sensors of other makers that send bytes. */
internal class I2cSensors(
    private val scene: NxtScene,
    private val machine: SimulatedRobot,
    private val streams: NoiseStreams,
    private val realism: Double,
    private val clock: Clock,
    private val air: InfraredAir,
    private val thermometer: Thermometer,
) {
    /**
     * The device of [part]; null if it sends no bytes.
     *
     * @param nameOf the name of its noise, made from that of its kind.
     */
    fun of(part: SensorPart, place: SensorPlace, nameOf: (String) -> String): I2cDevice? = when (part.sensor) {
        SensorKind.COMPASS -> CompassDevice(machine, streams, nameOf("compass"), realism)
        SensorKind.MINDSENSORS_COMPASS -> MindsensorsCompass(machine, streams, nameOf("mindsensors compass"), realism)

        SensorKind.HITECHNIC_COLOUR -> {
            ColourDevice(ColourSensorModel(scene, place, streams, nameOf("HiTechnic colour sensor"), realism), clock)
        }

        SensorKind.HITECHNIC_ACCELERATION -> {
            HitechnicAcceleration(accelerometer(place, nameOf("HiTechnic acceleration sensor")))
        }

        SensorKind.MINDSENSORS_ACCELERATION -> {
            val name = nameOf("mindsensors acceleration sensor")
            MindsensorsAcceleration(accelerometer(place, name), scene.trigonometry)
        }

        SensorKind.OPTICAL_DISTANCE -> {
            OpticalDevice(scene, place, streams, nameOf("optical distance sensor"), realism, clock)
        }

        SensorKind.INFRARED_SEEKER -> {
            FirstSeeker(SeekerEyes(scene, place, streams, nameOf("infrared seeker"), realism), clock)
        }

        SensorKind.INFRARED_SEEKER_2 -> {
            SecondSeeker(SeekerEyes(scene, place, streams, nameOf("infrared seeker V2"), realism), clock)
        }

        SensorKind.NXT_TEMPERATURE -> TemperatureDevice(thermometer, streams, nameOf("NXT temperature sensor"), realism)
        SensorKind.RCX_LINK -> RcxLinkDevice(air.placeAdapter())
        else -> null
    }

    private fun accelerometer(place: SensorPlace, name: String) =
        Accelerometer(machine, place, streams, name, realism, clock)
}
