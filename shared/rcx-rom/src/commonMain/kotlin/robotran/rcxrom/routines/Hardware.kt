package robotran.rcxrom.routines

import robotran.brick.controls.BrickButton
import robotran.brick.log.CallLog
import robotran.rcxrom.controls.Buttons
import robotran.rcxrom.controls.Motors
import robotran.rcxrom.display.Lcd
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.infrared.Serial
import robotran.rcxrom.memory.FirmwareTimers
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.Registers
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.ShellHardware
import robotran.rcxrom.sensors.Battery
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorExpectations
import robotran.rcxrom.sensors.Sensors
import robotran.rcxrom.sound.Speaker

/** The parts of a brick and the ROM that controls them, without an active firmware. */
internal class Hardware(air: InfraredAir = InfraredAir(), messages: BrickMessages) : ShellHardware {
    /** Virtual time, which passes only in [tick]. */
    var milliseconds = 0L
        private set

    /** Whether the timer drives motors, sounds and sensors. */
    override var timerRuns = true

    /** Whether the processor sleeps until On-Off wakes it. */
    var asleep = false
        private set

    val memory = RcxMemory()
    val motors = Motors(memory)
    val lcd = Lcd(memory)
    val speaker = Speaker(memory, clock = { milliseconds }, drawn = { lcd.glass })
    val buttons = Buttons(memory)
    val sensors = Sensors(memory)
    val expectations = SensorExpectations()
    val timers = FirmwareTimers(memory)
    val serial = Serial(memory, air.open(), clock = { milliseconds })
    val log = CallLog()
    val sounds = SoundRoutines(memory, speaker, messages)

    override val rom = VirtualRom(
        memory,
        log,
        MotorRoutines(memory, motors, messages).routines + LcdRoutines(lcd, messages).routines +
            LcdSegmentRoutines(
                memory,
                lcd,
                messages,
            ).routines + ButtonRoutines(memory, buttons, lcd, messages).routines +
            PowerRoutines(memory, ::sleep, messages).routines + sounds.routines +
            SensorRoutines(memory, sensors, expectations, messages).routines +
            SerialRoutines(memory, serial, sounds, messages).routines +
            TimerRoutines(this, messages).routines,
        sensors,
        expectations,
        buttons,
        messages,
        serial.line,
        clock = { milliseconds },
    )

    init {
        measureBattery(Battery.FULL_RAW)
        val pins = Registers.DISPLAY_PINS or Registers.SPEAKER_PIN or Registers.UNKNOWN_PIN
        memory.setBits(Registers.PORT_6_DIRECTIONS, pins, on = true)
        memory.setBits(Registers.PORT_5_DIRECTIONS, Registers.MEMORY_POWER_PIN, on = true)
    }

    /** Sets what the battery's converter measures from now on, 0..1023. */
    fun measureBattery(raw: Int) {
        memory.writeShort(
            Registers.CONVERTER_OF_BATTERY,
            raw.coerceIn(0, SensorCode.OPEN_RAW) shl Registers.CONVERTER_SHIFT,
        )
    }

    val batteryRaw: Int get() = memory.readWord(Registers.CONVERTER_OF_BATTERY) shr Registers.CONVERTER_SHIFT

    /** Whether the loudspeaker stays silent unless a new sound is requested. */
    override val isSilent: Boolean get() = !timerRuns || memory.readByte(Speaker.PLAYING_FLAG) == 0

    /** Puts the processor to sleep. If On-Off is held, it wakes up at once. */
    private fun sleep() {
        asleep = BrickButton.ON_OFF !in buttons.pressed
    }

    /** Wakes the processor when On-Off is pressed. */
    override fun wake() {
        asleep = false
    }

    /** Stops what the timer drives, so that the firmware that begins then initializes the brick. */
    fun reset() {
        motors.shutdown()
        speaker.silence()
        timerRuns = false
        asleep = false
    }

    override val isAsleep: Boolean get() = asleep

    override val pressedButtons: Set<BrickButton> get() = buttons.pressed

    override fun asFirmware(work: () -> Unit) = speaker.asFirmware(work)

    override fun startExpectations(place: () -> Pair<Int, String?>) {
        expectations.place = place
        expectations.startRun()
    }

    /** Advances time by one millisecond. */
    fun tick() {
        milliseconds++
        if (asleep) return serial.sleep()
        if (timerRuns) {
            timers.tick()
            motors.tick()
            speaker.tick()
            sensors.tick(milliseconds)
        }
        serial.tick()
    }
}
