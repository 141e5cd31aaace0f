package robotran.rom

/**
 * A virtual RCX with its firmware. It begins switched on, just as if somebody had pressed On-Off at its millisecond 0, so that pressing and
 * releasing [BrickButton.RUN] is all that is needed to start the first program. Time passes only in [tick].
 *
 * What the buttons do while no program runs is that of the leJOS shell: Prgm chooses the next program, Run starts it when let go,
 * On-Off switches the brick off when let go, and on again. While a program runs, View, Prgm and Run belong to the program;
 * On-Off switches the brick off, or, with Run held down too, ends the program.
 *
 * @param programs the program slots; may be empty.
 */
class Brick(private val programs: List<RcxProgram>) {
    private var milliseconds = 0L
    private val pressed = mutableSetOf<BrickButton>()

    /** Every ROM call so far, of the program and of the firmware. */
    val log = RomLog()

    /** The brick as it is now. */
    val state: BrickState
        get() = BrickState(
            milliseconds, true, LcdGlass.BLANK, MotorPort.entries.map { MotorState(it, MotorMode.FLOAT, 0) },
            pressed.toSet(), 0, RunState.Idle, false,
        )

    /** What [port] is told to do; the same as in [state], but cheaper. */
    fun motor(port: MotorPort): MotorState = state.motors[port.ordinal]

    /** Whether [port] is switched on in this millisecond of its pulsed power; always false when it floats. */
    fun motorSwitchedOn(port: MotorPort): Boolean = motor(port).mode != MotorMode.FLOAT

    /** A finger goes down on [button]. Does nothing if it is down already. */
    fun press(button: BrickButton) {
        pressed += button
    }

    /** The finger comes off [button]. Does nothing if it is up already. */
    fun release(button: BrickButton) {
        pressed -= button
    }

    /** Ends the running program, if there is one, as no single button of a real brick does. */
    fun stopProgram() = Unit

    /** Lets one millisecond pass: first the firmware's work, then the program's, until its share of the time is used up or it waits. */
    fun tick() {
        milliseconds++
    }

    /** The tones begun since the last call; only the newest thousand, if nobody asks for long. */
    fun takeSounds(): List<SoundEvent> = emptyList()
}
