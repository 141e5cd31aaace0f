package robotran.legofirmware.run

import robotran.brick.program.RuntimeWarning
import robotran.legofirmware.device.Clocks
import robotran.legofirmware.image.CodeLine
import robotran.legofirmware.messages.FirmwareRunMessages
import robotran.legofirmware.task.Task
import robotran.legofirmware.task.TaskState
import robotran.rcxrom.program.Rom

/**
 * LEGO's firmware on a brick: what it keeps for all programs, and the virtual machine that runs one of them. Time passes
 * with the brick's clock; [tick] must be called in each millisecond, and [step] in those of a running program.
 */
internal class FirmwareMachine(rom: Rom, messages: FirmwareRunMessages) {
    val core = Core(rom, messages)
    private val interpreter = Interpreter(core)
    private val display = Display(core)
    private val requests = Requests(core, interpreter)
    private var nextOpcodeAt = 0L
    private var lastTick = -1L

    /** The program that runs, or ran last; null if none has. */
    var program: ProgramCode? = null
        private set

    /** Whether a program runs. It is over when its last task has ended. */
    var isRunning = false
        private set

    /** Whether the brick was used since the last [takeActivity]: it switches itself off after a time without that. */
    private var wasActive = false

    val warnings: List<RuntimeWarning> get() = core.warnings

    /** Makes the View button's step. */
    fun viewNext() {
        core.devices.viewing.showNext()
        display.tick(isRunning, atOnce = true)
    }

    /** Selects a slot while nothing runs. */
    fun select(slot: Int) {
        core.devices.slot = slot
        display.tick(isRunning, atOnce = true)
    }

    /** What the remote control wants; null if nothing. */
    fun takeRemoteCommand(): RemoteCommand? = requests.takeCommand()

    fun takeActivity(): Boolean = (wasActive || isRunning).also { wasActive = false }

    /** Sets the sensors as they are when the firmware begins, and shows the watch. */
    fun begin() {
        core.at(null)
        core.devices.inputs.begin()
        redraw()
    }

    /** Writes the whole display again, after it was cleared. */
    fun redraw() {
        display.begin()
        display.tick(isRunning, atOnce = true)
    }

    /** Starts task 0 of [code]. */
    fun start(code: ProgramCode) {
        program = code
        core.begin(code.image.target)
        core.devices.outputs.resetGlobalLayer()
        core.devices.sounds.isMuted = false
        core.devices.random.stir(core.now)
        core.devices.viewing.forgetUserValue()
        core.tasks.load(code.image)
        core.tasks.start(0)
        interpreter.lines = code.lines
        nextOpcodeAt = core.now
        isRunning = core.tasks.anyAlive
        display.tick(isRunning, atOnce = true)
    }

    /** Ends the program and switches the motors off. */
    fun stop() {
        core.at(null)
        core.tasks.stopAll()
        core.devices.outputs.stop()
        finish()
    }

    /** What happens besides programs, once in each millisecond; further calls in the same do nothing. */
    fun tick() {
        if (core.now == lastTick) return
        lastTick = core.now
        if (requests.tick(isRunning)) wasActive = true
        core.devices.infrared.tick()
        if (isRunning && !core.tasks.anyAlive) finish()
        if (isRunning) core.events.tick(core.now)
        core.at(null)
        display.tick(isRunning)
    }

    /** The task whose instruction is due now; null if none is. */
    fun due(): Task? = if (isRunning && core.now >= nextOpcodeAt) core.tasks.next(core.now) else null

    /** Executes an instruction of [task], which is [due]. */
    fun step(task: Task) {
        core.tasks.took(task)
        interpreter.step(task)
        nextOpcodeAt = core.now + core.model.opcodeMilliseconds
        if (!core.tasks.anyAlive) finish()
    }

    /** The line in the source of the instruction that [task] is at; null if there is none. */
    fun lineOf(task: Task): CodeLine? =
        task.placeAt(core.now)?.let { interpreter.lines.lineOf(it.chunk.id, it.address) }

    /** The statement that [task] is about to begin; null if it is in the middle of one, for example of a wait. */
    fun beginningOf(task: Task): CodeLine? = task.location?.takeUnless { task.isWaiting(core.now) }
        ?.let { interpreter.lines.beginningAt(it.chunk.id, it.address) }

    val state: FirmwareState
        get() = FirmwareState(
            core.devices.slot,
            program?.name,
            core.variables.all(),
            program?.variableNames.orEmpty(),
            List(Clocks.TIMERS) { core.devices.clocks.fastTimer(it) },
            core.devices.clocks.watch,
            core.devices.infrared.message,
            core.devices.datalog.entries(),
            core.devices.datalog.capacity,
            core.tasks.all.filter { it.isAlive }.map {
                val waitsUntil = it.wakesAt.takeIf { _ -> it.state == TaskState.WAITING }
                TaskView(
                    it.number,
                    waitsUntil,
                    it.locals.toList(),
                    it.priority,
                    it.monitor?.mask ?: 0,
                    it.access?.mask ?: 0,
                )
            },
        )

    private fun finish() {
        if (!isRunning) return
        isRunning = false
        wasActive = true
        display.tick(isRunning = false, atOnce = true)
    }
}
