package robotran.rom

/** The parts of a brick and the ROM that works them, with no firmware that acts of itself. */
internal class Hardware {
    val memory = RcxMemory()
    val motors = Motors(memory)
    val lcd = Lcd(memory)
    val speaker = Speaker(memory)
    val buttons = Buttons()
    val sensors = Sensors(memory)
    val log = RomLog()

    /** Virtual time, which passes only in [tick]. */
    var milliseconds = 0L
        private set

    val rom = VirtualRom(
        memory,
        log,
        MotorRoutines(motors).routines + LcdRoutines(lcd).routines + LcdSegmentRoutines(memory, lcd).routines +
            ButtonRoutines(memory, buttons).routines + SoundRoutines(memory, speaker).routines +
            SensorRoutines(sensors).routines,
        sensors,
        clock = { milliseconds },
    )

    /** Lets one millisecond pass. */
    fun tick() {
        milliseconds++
        motors.tick()
        speaker.tick(milliseconds)
        sensors.tick(milliseconds)
    }
}
