package robotran.robolang.translate

import robotran.robolang.SensorEvent
import java.lang.reflect.InvocationTargetException
import kotlin.concurrent.thread

/** A call of the ROM as both sides of the comparison tell it. */
internal data class TimedCall(val milliseconds: Long, val address: Int, val arguments: List<Int>)

/** What a run meets, and when it is stopped if it does not end. */
internal class RunTerms(val sensors: List<SensorEvent>, val maxCalls: Int, val lastMillisecond: Long)

/** Runs the class [className] among [classes], the stand-ins for leJOS included, until it ends or [terms] stop it. */
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

private fun callMain(program: Class<*>) {
    try {
        program.getMethod("main", Array<String>::class.java).invoke(null, null)
    } catch (failure: InvocationTargetException) {
        throw failure.targetException
    }
}

/** Only a guard against a translation that hangs: every run ends after so many calls or so much virtual time. */
private const val LONGEST_RUN_MILLISECONDS = 600_000L

/** Fresh classes for each run: their fields are those of a program that has just been loaded. */
private class ClassesOfOneRun(private val classes: Map<String, ByteArray>) :
    ClassLoader(ClassesOfOneRun::class.java.classLoader) {
    override fun findClass(name: String): Class<*> {
        val bytes = classes[name] ?: throw ClassNotFoundException(name)
        return defineClass(name, bytes, 0, bytes.size)
    }
}
