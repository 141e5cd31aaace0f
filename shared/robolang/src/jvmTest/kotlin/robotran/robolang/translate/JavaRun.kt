package robotran.robolang.translate

import robotran.robolang.SensorEvent
import java.lang.reflect.InvocationTargetException
import kotlin.concurrent.thread

/** A ROM call of either run in a comparison. */
internal data class TimedCall(val milliseconds: Long, val address: Int, val arguments: List<Int>)

/** The sensor values of a run, and the limits at which it is stopped. */
internal class RunTerms(val sensors: List<SensorEvent>, val maxCalls: Int, val lastMillisecond: Long)

/** Runs [className] of [classes], which include the leJOS stubs, until it ends or reaches a limit of [terms]. */
internal fun runJava(classes: Map<String, ByteArray>, className: String, terms: RunTerms): List<TimedCall> {
    val loader = ClassesOfOneRun(classes)
    val rom = loader.loadClass("josx.platform.rcx.ROM")
    rom.getField("mostCalls").setInt(null, terms.maxCalls)
    rom.getField("lastMillisecond").setLong(null, terms.lastMillisecond)
    @Suppress("UNCHECKED_CAST")
    val sensors = rom.getField("sensors").get(null) as MutableList<IntArray>
    terms.sensors.forEach { sensors += intArrayOf(it.port, it.milliseconds.toInt(), it.raw) }
    var problem: Throwable? = null
    val runner = thread(isDaemon = true) {
        try {
            loader.loadClass("josx.platform.rcx.Turns").getMethod("runAll", Runnable::class.java)
                .invoke(null, Runnable { callMain(loader.loadClass(className)) })
        } catch (failure: InvocationTargetException) {
            problem = failure.targetException
        }
    }
    runner.join(LONGEST_RUN_MILLISECONDS)
    if (runner.isAlive) throw AssertionError("it does not come to an end")
    problem?.let { throw it }
    return (rom.getField("calls").get(null) as List<*>).map { words ->
        val call = words as IntArray
        TimedCall(call[0].toLong(), call[1], call.drop(2))
    }
}

internal fun callMain(program: Class<*>) {
    try {
        program.getMethod("main", Array<String>::class.java).invoke(null, null)
    } catch (failure: InvocationTargetException) {
        throw failure.targetException
    }
}

/** The timeout for a translation that hangs; others end by themselves or at the limits of [RunTerms]. */
private const val LONGEST_RUN_MILLISECONDS = 600_000L

/** Loads the classes anew for each run, so that their static fields have their initial values. */
internal class ClassesOfOneRun(private val classes: Map<String, ByteArray>) :
    ClassLoader(ClassesOfOneRun::class.java.classLoader) {
    override fun findClass(name: String): Class<*> {
        val bytes = classes[name] ?: throw ClassNotFoundException(name)
        return defineClass(name, bytes, 0, bytes.size)
    }
}
