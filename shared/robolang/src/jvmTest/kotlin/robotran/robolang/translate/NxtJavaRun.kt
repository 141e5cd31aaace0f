package robotran.robolang.translate

import robotran.brick.program.ProgramStatus
import robotran.nxt.FakeNxt
import robotran.nxt.display.BitBlt
import robotran.nxt.display.Picture
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.program.NxtProgram
import robotran.robolang.Expectations
import robotran.robolang.Senses
import java.lang.reflect.InvocationTargetException
import java.lang.reflect.Proxy
import kotlin.concurrent.thread

/** An NXT that notes all calls with their times, and stops a run after a while. */
internal class NotingNxt(private val expected: Expectations, private val nxt: FakeNxt = FakeNxt()) : Nxt by nxt {
    private val senses = Senses(expected).also { it.apply(nxt) }

    val noted = mutableListOf<String>()

    val isOver: Boolean get() = noted.size >= MAX_CALLS || nxt.milliseconds > LAST_MILLISECOND

    override fun call(call: NxtCall, sourceLine: Int, sourceFile: String?): Int {
        noted += "$milliseconds $call"
        return nxt.call(call, sourceLine, sourceFile)
    }

    override fun bitBlt(source: Picture, part: BitBlt, sourceLine: Int, sourceFile: String?) {
        noted += "$milliseconds bitBlt $part"
        nxt.bitBlt(source, part, sourceLine, sourceFile)
    }

    fun advance() {
        nxt.advance(1)
        senses.apply(nxt)
    }

    /** The calls up to the limits. */
    val calls: List<String>
        get() = noted.filter { it.substringBefore(' ').toLong() <= LAST_MILLISECOND }.take(MAX_CALLS)

    private companion object {
        const val MAX_CALLS = 500
        const val LAST_MILLISECOND = 20_000L
    }
}

/** The interpreter's calls; null if it fails, which a brick may not, or loops forever without a call. */
internal fun interpretOnNxt(program: NxtProgram, expected: Expectations): List<String>? {
    val nxt = NotingNxt(expected)
    val run = program.start(nxt)
    var steps = 0
    while (!nxt.isOver) {
        if (steps++ == MAX_STEPS) return null
        when (val status = run.resume(1)) {
            ProgramStatus.Running -> Unit
            is ProgramStatus.Waiting -> while (nxt.milliseconds < status.untilMilliseconds) nxt.advance()
            ProgramStatus.Ended -> break
            is ProgramStatus.Paused, is ProgramStatus.ThreadFailed, is ProgramStatus.Failed -> return null
        }
    }
    return nxt.calls
}

/** Runs [className] of [classes], which include the stubs of leJOS NXJ, until it ends or reaches a limit. */
internal fun runNxtJava(classes: Map<String, ByteArray>, className: String, expected: Expectations): List<String> {
    val loader = ClassesOfOneRun(classes)
    val nxt = NotingNxt(expected)
    val brick = loader.loadClass("lejos.nxt.Brick")
    val over = loader.loadClass("lejos.nxt.Brick\$Over")
    val end = { throw over.getDeclaredConstructor().newInstance() as RuntimeException }
    val type = loader.loadClass("lejos.nxt.Brick\$Calls")
    val calls = Proxy.newProxyInstance(loader, arrayOf(type)) { _, method, arguments ->
        answer(nxt, method.name, arguments.orEmpty(), end)
    }
    brick.getField("calls").set(null, calls)
    var problem: Throwable? = null
    val runner = thread(isDaemon = true) {
        try {
            loader.loadClass(className).getMethod("main", Array<String>::class.java).invoke(null, null)
        } catch (failure: InvocationTargetException) {
            problem = causeOf(failure).takeUnless(over::isInstance)
        }
    }
    runner.join(LONGEST_RUN_MILLISECONDS)
    if (runner.isAlive) throw AssertionError("$className does not come to an end")
    problem?.let { throw AssertionError(className, it) }
    return nxt.calls
}

private fun causeOf(failure: InvocationTargetException): Throwable {
    val target = failure.targetException
    return if (target is ExceptionInInitializerError) target.exception else target
}

private fun answer(nxt: NotingNxt, name: String, arguments: Array<out Any?>, end: () -> Nothing): Any? {
    if (nxt.isOver) end()
    val port = arguments.lastOrNull() as? Int ?: 0
    return when (name) {
        "call" -> {
            nxt.call(
                NxtCall(
                    checkNotNull(NxtNative.of(arguments[0] as Int)),
                    arguments[1] as IntArray,
                    arguments[2] as String?,
                    arguments[3] as ByteArray?,
                ),
                sourceLine = 0,
            )
        }

        "clearRow" -> {
            val display = Picture(nxt.displayMemory, WIDTH, HEIGHT)
            nxt.bitBlt(display, BitBlt(0, ROW * port, 0, ROW * port, WIDTH, ROW, operation = 0), sourceLine = 0)
            null
        }

        "read" -> read(nxt, arguments[0] as String, port)
        "position" -> nxt.regulator(port).position

        "sleep" -> {
            val until = nxt.milliseconds + arguments[0] as Long
            while (nxt.milliseconds < until) nxt.advance()
            null
        }

        else -> nxt.milliseconds
    }
}

private fun read(nxt: NotingNxt, what: String, port: Int): Int = when (what) {
    "analog" -> nxt.analog(port)
    "status" -> nxt.i2cStatus(port)

    "answer" -> ByteArray(1).let { bytes ->
        val count = nxt.i2cComplete(port, bytes)
        if (count < 0) count else bytes[0].toInt() and 0xFF
    }

    "colour" -> nxt.colour(port)?.kind?.code ?: -1
    "buttons" -> nxt.buttons()
    "battery" -> nxt.batteryStatus()
    "tacho" -> nxt.tachoCount(port)
    else -> if (nxt.regulator(port).isMoving) 1 else 0
}

private const val MAX_STEPS = 100_000
private const val LONGEST_RUN_MILLISECONDS = 600_000L
private const val WIDTH = 100
private const val HEIGHT = 64
private const val ROW = 8
