package robotran.tinyvm.natives

import robotran.tinyvm.config.Quirk
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.ThreadState
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.action
import robotran.tinyvm.run.rcx

/** `java.lang.Object`. Source: leJOS `threads.c`. */
internal val objectMethods: Map<String, NativeMethod> = mapOf(
    "java/lang/Object.wait()V" to action { machine, thread, first ->
        await(machine, thread, thread.stack[first], null)
    },
    "java/lang/Object.wait(J)V" to action { machine, thread, first ->
        await(machine, thread, thread.stack[first], thread.stack[first + 1])
    },
    "java/lang/Object.notify()V" to
        action { machine, thread, first -> wake(machine, thread, thread.stack[first], all = false) },
    "java/lang/Object.notifyAll()V" to
        action { machine, thread, first -> wake(machine, thread, thread.stack[first], all = true) },
    "java/lang/Object.getDataAddress(Ljava/lang/Object;)I" to NativeMethod { machine, thread, first ->
        machine.rcx.arrays.addressOf(thread.stack[first])
    },
)

/** Makes [thread] release the monitor [lock] and wait; 0 or null milliseconds mean forever. */
private fun await(machine: VirtualMachine, thread: VmThread, lock: Int, milliseconds: Int?) {
    val isOwner = machine.monitors.isOwner(lock, thread)
    val isNegative = milliseconds != null && milliseconds < 0
    if (isOwner && isNegative) machine.addWarning(Quirk.NEGATIVE_TIME)
    when {
        !isOwner -> machine.raise(thread, BuiltInException.ILLEGAL_MONITOR_STATE)

        machine.model.hasQuirks -> {
            release(machine, thread, lock)
            thread.wakeTime =
                if (milliseconds == null || milliseconds == 0) 0 else wakeTimeOfBrick(machine, milliseconds)
        }

        isNegative -> machine.raise(thread, BuiltInException.ILLEGAL_ARGUMENT)
        thread.isInterrupted -> interruptNow(machine, thread)

        else -> {
            release(machine, thread, lock)
            thread.wakeTime =
                if (milliseconds == null || milliseconds == 0) 0 else machine.milliseconds + milliseconds
        }
    }
}

private fun release(machine: VirtualMachine, thread: VmThread, lock: Int) {
    thread.releasedEntries = machine.monitors.exitCompletely(lock, thread)
    thread.awaitedLock = lock
    thread.state = ThreadState.WAITING
}

private fun wake(machine: VirtualMachine, thread: VmThread, lock: Int, all: Boolean) {
    if (machine.monitors.isOwner(lock, thread)) {
        machine.scheduler.notify(lock, all)
    } else {
        machine.raise(thread, BuiltInException.ILLEGAL_MONITOR_STATE)
    }
}

/** Clears the interrupt flag of [thread] and raises `InterruptedException`. */
internal fun interruptNow(machine: VirtualMachine, thread: VmThread) {
    thread.isInterrupted = false
    machine.raise(thread, BuiltInException.INTERRUPTED)
}
