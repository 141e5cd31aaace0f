package robotran.tinyvm.natives

import robotran.tinyvm.config.Quirk
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.ThreadState
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VirtualMachineConstants
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.action
import robotran.tinyvm.run.wordOf

private const val TIME_BITS = 0xFFFFFFFFL

/** `java.lang.Thread`. Source: leJOS `threads.c`, `native.c`. */
internal val threadMethods: Map<String, NativeMethod> = mapOf(
    "java/lang/Thread.start()V" to
        action { machine, thread, first -> start(machine, thread, threadAt(machine, thread, first)) },
    "java/lang/Thread.yield()V" to action { machine, _, _ -> machine.isYielding = true },
    "java/lang/Thread.sleep(J)V" to action { machine, thread, first -> sleep(machine, thread, thread.stack[first]) },
    "java/lang/Thread.currentThread()Ljava/lang/Thread;" to NativeMethod { _, thread, _ -> thread.reference },
    "java/lang/Thread.getPriority()I" to
        NativeMethod { machine, thread, first -> threadAt(machine, thread, first).priority },
    "java/lang/Thread.setPriority(I)V" to action { machine, thread, first ->
        val priority = thread.stack[first + 1]
        if (priority in VirtualMachineConstants.MIN_PRIORITY..VirtualMachineConstants.MAX_PRIORITY) {
            machine.scheduler.setPriority(threadAt(machine, thread, first), priority)
        } else {
            machine.raise(thread, BuiltInException.ILLEGAL_ARGUMENT)
        }
    },
    "java/lang/Thread.interrupt()V" to
        action { machine, thread, first -> interrupt(machine, threadAt(machine, thread, first)) },
    "java/lang/Thread.interrupted()Z" to NativeMethod { _, thread, _ ->
        wordOf(thread.isInterrupted).also {
            thread.isInterrupted = false
            thread.isInterruptDue = false
        }
    },
    "java/lang/Thread.isInterrupted()Z" to NativeMethod { machine, thread, first ->
        wordOf(threadAt(machine, thread, first).isInterrupted)
    },
    "java/lang/Thread.isDaemon()Z" to
        NativeMethod { machine, thread, first -> wordOf(threadAt(machine, thread, first).isDaemon) },
    "java/lang/Thread.setDaemon(Z)V" to action { machine, thread, first ->
        threadAt(machine, thread, first).isDaemon = thread.stack[first + 1] != 0
    },
    "java/lang/Thread.join()V" to action { machine, _, _ -> machine.addWarning(Quirk.JOIN_DOES_NOTHING) },
    "java/lang/Thread.join(J)V" to action { machine, _, _ -> machine.addWarning(Quirk.JOIN_DOES_NOTHING) },
)

private fun threadAt(machine: VirtualMachine, thread: VmThread, place: Int): VmThread =
    machine.threadOf(thread.stack[place])

private fun start(machine: VirtualMachine, starter: VmThread, started: VmThread) {
    when {
        started.state != ThreadState.NEW -> machine.raise(starter, BuiltInException.ILLEGAL_STATE)
        machine.scheduler.hasRoom && machine.stacks.create(started) -> machine.start(started)
        else -> machine.raise(starter, BuiltInException.OUT_OF_MEMORY)
    }
}

private fun sleep(machine: VirtualMachine, thread: VmThread, milliseconds: Int) {
    if (milliseconds < 0) machine.addWarning(Quirk.NEGATIVE_TIME)
    when {
        machine.model.hasQuirks -> {
            thread.wakeTime = maxOf(1, wakeTimeOfBrick(machine, milliseconds))
            thread.state = ThreadState.SLEEPING
        }

        milliseconds < 0 -> machine.raise(thread, BuiltInException.ILLEGAL_ARGUMENT)
        thread.isInterrupted -> interruptNow(machine, thread)

        else -> {
            thread.wakeTime = maxOf(1, machine.milliseconds + milliseconds)
            thread.state = ThreadState.SLEEPING
        }
    }
}

/** When a brick ends a pause of [milliseconds]: it calculates with 32 bits without a sign. */
internal fun wakeTimeOfBrick(machine: VirtualMachine, milliseconds: Int): Long =
    (machine.milliseconds + milliseconds) and TIME_BITS

/** A brick only notes it: a sleep or a wait looks at it when the threads' turns are given. */
private fun interrupt(machine: VirtualMachine, thread: VmThread) {
    if (machine.model.hasQuirks) {
        thread.isInterrupted = true
        thread.isInterruptDue = false
        return
    }
    when (thread.state) {
        ThreadState.SLEEPING -> {
            thread.state = ThreadState.READY
            machine.raise(thread, BuiltInException.INTERRUPTED)
        }

        ThreadState.WAITING -> {
            thread.state = ThreadState.BLOCKED
            machine.raise(thread, BuiltInException.INTERRUPTED)
        }

        else -> thread.isInterrupted = true
    }
}
