package robotran.robolang.translate

import java.lang.reflect.InvocationTargetException
import kotlin.concurrent.thread

/** A call of the ROM as both sides of the comparison tell it. */
internal data class TimedCall(val milliseconds: Long, val address: Int, val arguments: List<Int>)

/** Runs the class [className] among [classes] until it ends, or has made [mostCalls], or [lastMillisecond] has passed. */
internal fun runJava(classes: Map<String, ByteArray>, className: String, mostCalls: Int, lastMillisecond: Long): List<TimedCall> {
    val loader = ClassesOfOneRun(classes)
    val rom = loader.loadClass("josx.platform.rcx.ROM")
    rom.getField("mostCalls").setInt(null, mostCalls)
    rom.getField("lastMillisecond").setLong(null, lastMillisecond)
    var problem: Throwable? = null
    val runner = thread(isDaemon = true) {
        try {
            loader.loadClass(className).getMethod("main", Array<String>::class.java).invoke(null, null)
        } catch (failure: InvocationTargetException) {
            problem = failure.targetException.takeIf { it.javaClass.name != "josx.platform.rcx.ROM\$Over" }
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

private const val LONGEST_RUN_MILLISECONDS = 5_000L

/** Fresh classes for each run: their fields are those of a program that has just been loaded. */
private class ClassesOfOneRun(private val classes: Map<String, ByteArray>) : ClassLoader(ClassesOfOneRun::class.java.classLoader) {
    override fun findClass(name: String): Class<*> {
        val bytes = classes[name] ?: throw ClassNotFoundException(name)
        return defineClass(name, bytes, 0, bytes.size)
    }
}
