package robotran.tinyvm.natives.nxj

import robotran.nxt.bluetooth.LinkStatus
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.action
import robotran.tinyvm.run.brick
import robotran.tinyvm.run.wordOf

private const val LINK = "lejos/nxt/comm/BTLink"
private const val NAME_BYTES = 16
private const val BYTE = 0xFF

/** `lejos.nxt.comm.BTLink`, and what writes into the log. */
internal val radioMethods: Map<String, NativeMethod> = mapOf(
    "$LINK.name([B)I" to NativeMethod { machine, thread, first ->
        val into = thread.stack[first]
        val name = machine.brick.nxt.name.encodeToByteArray()
        if (into == 0) {
            nullPointer(machine, thread)
        } else {
            val count = minOf(name.size, NAME_BYTES, machine.heap.length(into))
            putBytes(machine, into, 0, name, count)
            count
        }
    },
    "$LINK.isKnown(Ljava/lang/String;)Z" to NativeMethod { machine, thread, first ->
        textAt(machine, thread, first)?.let { wordOf(machine.brick.nxt.knowsRobot(it)) } ?: 0
    },
    "$LINK.partner(I[B)I" to NativeMethod { machine, thread, first ->
        val name = machine.brick.nxt.link(thread.stack[first])?.partner.orEmpty().encodeToByteArray()
        val into = thread.stack[first + 1]
        if (into == 0) {
            nullPointer(machine, thread)
        } else {
            val count = minOf(name.size, NAME_BYTES, machine.heap.length(into))
            putBytes(machine, into, 0, name, count)
            count
        }
    },
    "$LINK.open(Ljava/lang/String;)I" to opens(NxtNative.OPEN),
    "$LINK.openCable(Ljava/lang/String;)I" to opens(NxtNative.OPEN_CABLE),
    "$LINK.listen(I)I" to calls(NxtNative.LISTEN),
    "$LINK.listenCable(I)I" to calls(NxtNative.LISTEN_CABLE),
    "$LINK.status(I)I" to reads { nxt, arguments -> (nxt.link(arguments(0))?.status ?: LinkStatus.CLOSED).code },
    "$LINK.write(I[BII)I" to NativeMethod { machine, thread, first ->
        val stack = thread.stack
        val bytes = bytesOf(machine, thread, stack[first + 1], stack[first + 2], stack[first + 3])
        if (bytes == null) {
            0
        } else {
            machine.brick.call(thread, NxtCall(NxtNative.WRITE, intArrayOf(stack[first]), bytes = bytes))
        }
    },
    "$LINK.read(I[BII)I" to NativeMethod { machine, thread, first ->
        val stack = thread.stack
        if (!hasPart(machine, thread, stack[first + 1], stack[first + 2], stack[first + 3])) {
            0
        } else {
            val into = ByteArray(stack[first + 3])
            val count = machine.brick.nxt.link(stack[first])?.read(into) ?: -1
            putBytes(machine, stack[first + 1], stack[first + 2], into, maxOf(0, count))
            count
        }
    },
    "$LINK.close(I)V" to calls(NxtNative.CLOSE),
    "lejos/nxt/LCDOutputStream.consoleLine([BI)V" to action { machine, thread, first ->
        val bytes = bytesOf(machine, thread, thread.stack[first], 0, thread.stack[first + 1])
        if (bytes != null) {
            val text = bytes.map { (it.toInt() and BYTE).toChar() }.joinToString("")
            machine.brick.call(thread, NxtCall(NxtNative.CONSOLE_LINE, text = text))
        }
    },
    "lejos/nxt/comm/RConsole.log(Ljava/lang/String;)V" to action { machine, thread, first ->
        textAt(machine, thread, first)?.let { machine.brick.call(thread, NxtCall(NxtNative.CONSOLE_LINE, text = it)) }
    },
)

/** Begins to connect to the robot whose name is the argument. */
private fun opens(native: NxtNative) = NativeMethod { machine, thread, first ->
    textAt(machine, thread, first)?.let { machine.brick.call(thread, NxtCall(native, text = it)) } ?: 0
}
