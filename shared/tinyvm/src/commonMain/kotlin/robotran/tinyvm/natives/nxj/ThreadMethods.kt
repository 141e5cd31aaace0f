package robotran.tinyvm.natives.nxj

import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.natives.interruptNow
import robotran.tinyvm.natives.threadMethods
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.ThreadState
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.action
import robotran.tinyvm.run.longAt

private const val THREAD = "java/lang/Thread"
private const val OBJECT = "java/lang/Object"

/** `java.lang.Thread`, and waiting in `Object`. */
internal val nxjThreadMethods: Map<String, NativeMethod> = listOf(
    "start()V",
    "yield()V",
    "currentThread()Ljava/lang/Thread;",
    "getPriority()I",
    "setPriority(I)V",
    "interrupted()Z",
    "isInterrupted()Z",
    "isDaemon()Z",
    "setDaemon(Z)V",
).associate { "$THREAD.$it" to threadMethods.getValue("$THREAD.$it") } + mapOf(
    "$THREAD.sleep(J)V" to action { machine, thread, first ->
        standStill(machine, thread, longAt(thread.stack, first), isForever = false) { ThreadState.SLEEPING }
    },
    "$THREAD.join()V" to action { machine, thread, first -> join(machine, thread, thread.stack[first], 0) },
    "$THREAD.join(J)V" to action { machine, thread, first ->
        join(machine, thread, thread.stack[first], longAt(thread.stack, first + 1))
    },
    "$THREAD.interrupt()V" to action { machine, thread, first ->
        interrupt(machine, machine.threadOf(thread.stack[first]))
    },
    "$OBJECT.wait()V" to action { machine, thread, first -> await(machine, thread, thread.stack[first], 0) },
    "$OBJECT.wait(J)V" to action { machine, thread, first ->
        await(machine, thread, thread.stack[first], longAt(thread.stack, first + 1))
    },
)

/** The longest time; more is for ever. */
private const val LONGEST = Int.MAX_VALUE.toLong()

/**
 * Lets [thread] stand still in the state that [begin] gives, for [milliseconds] or for ever, unless it is interrupted.
 */
private inline fun standStill(
    machine: VirtualMachine,
    thread: VmThread,
    milliseconds: Long,
    isForever: Boolean,
    begin: () -> ThreadState,
) {
    when {
        milliseconds < 0 -> machine.raise(thread, BuiltInException.ILLEGAL_ARGUMENT)
        thread.isInterrupted -> interruptNow(machine, thread)

        else -> {
            val time = minOf(milliseconds, LONGEST)
            thread.wakeTime = if (isForever) 0 else maxOf(1, machine.milliseconds + time)
            thread.state = begin()
        }
    }
}

private fun await(machine: VirtualMachine, thread: VmThread, lock: Int, milliseconds: Long) {
    if (!machine.monitors.isOwner(lock, thread)) return machine.raise(thread, BuiltInException.ILLEGAL_MONITOR_STATE)
    standStill(machine, thread, milliseconds, milliseconds == 0L || milliseconds > LONGEST) {
        thread.releasedEntries = machine.monitors.exitCompletely(lock, thread)
        thread.awaitedLock = lock
        ThreadState.WAITING
    }
}

private fun join(machine: VirtualMachine, thread: VmThread, reference: Int, milliseconds: Long) {
    val awaited = machine.threadOf(reference)
    if (!awaited.isAlive && milliseconds >= 0 && !thread.isInterrupted) return
    standStill(machine, thread, milliseconds, milliseconds == 0L || milliseconds > LONGEST) {
        thread.awaitedThread = awaited
        ThreadState.JOINING
    }
}

private fun interrupt(machine: VirtualMachine, thread: VmThread) {
    when (thread.state) {
        ThreadState.SLEEPING, ThreadState.JOINING -> thread.state = ThreadState.READY
        ThreadState.WAITING -> thread.state = ThreadState.BLOCKED

        else -> {
            thread.isInterrupted = true
            return
        }
    }
    thread.awaitedThread = null
    machine.raise(thread, BuiltInException.INTERRUPTED)
}
