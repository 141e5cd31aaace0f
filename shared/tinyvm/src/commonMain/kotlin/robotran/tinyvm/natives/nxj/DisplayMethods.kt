package robotran.tinyvm.natives.nxj

import robotran.nxt.display.BitBlt
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.Font5x7
import robotran.nxt.display.Picture
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.tinyvm.config.NxtCosts
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.action
import robotran.tinyvm.run.brick

private const val LCD = "lejos/nxt/LCD"

/** `lejos.nxt.LCD`. */
internal val displayMethods: Map<String, NativeMethod> = mapOf(
    "$LCD.drawString(Ljava/lang/String;II)V" to action(::drawString),
    "$LCD.drawInt(III)V" to action { machine, thread, first ->
        val stack = thread.stack
        machine.charge(NxtCosts.DRAW_NUMBER)
        machine.brick.call(thread, NxtCall.of(NxtNative.DRAW_INT, stack[first], 0, stack[first + 1], stack[first + 2]))
    },
    "$LCD.drawInt(IIII)V" to calls(NxtNative.DRAW_INT, NxtCosts.DRAW_NUMBER),
    "$LCD.clear()V" to calls(NxtNative.CLEAR, NxtCosts.CLEAR_DISPLAY),
    "$LCD.asyncRefresh()V" to calls(NxtNative.ASYNC_REFRESH),
    "$LCD.getRefreshCompleteTime()I" to reads { nxt, _ -> nxt.refreshCompleteTime() },
    "$LCD.setAutoRefreshPeriod(I)I" to calls(NxtNative.SET_AUTO_REFRESH_PERIOD),
    "$LCD.setContrast(I)V" to calls(NxtNative.SET_CONTRAST),
    "$LCD.getDisplay()[B" to NativeMethod { machine, thread, _ ->
        val type = machine.program.bytes8
        made(machine, thread, if (type == null) 0 else machine.brick.display(type))
    },
    "$LCD.getSystemFont()[B" to NativeMethod { machine, thread, _ ->
        val type: ArrayType? = machine.program.bytes8
        made(machine, thread, if (type == null) 0 else machine.brick.font(type, Font5x7::bytes))
    },
    "$LCD.bitBlt([BIIII[BIIIIIII)V" to action(::bitBlt),
)

private fun drawString(machine: VirtualMachine, thread: VmThread, first: Int) {
    val text = textAt(machine, thread, first) ?: return
    machine.charge(NxtCosts.DRAW_TEXT + NxtCosts.DRAW_CHARACTER * text.length)
    machine.brick.call(thread, NxtCall.drawString(text, thread.stack[first + 1], thread.stack[first + 2]))
}

private fun bitBlt(machine: VirtualMachine, thread: VmThread, first: Int) {
    val a = IntArray(BIT_BLT_ARGUMENTS) { thread.stack[first + it] }
    val source = picture(machine, thread, a[0], a[1], a[2]) ?: return
    val target = picture(machine, thread, a[5], a[6], a[7]) ?: return
    val part = BitBlt(a[3], a[4], a[8], a[9], a[10], a[11], a[12])
    val dots = part.width.coerceIn(0, MOST_DOTS).toLong() * part.height.coerceIn(0, MOST_DOTS)
    machine.charge(NxtCosts.DRAW_PICTURE + (dots / NxtCosts.DOTS_IN_A_BYTECODE).toInt())
    val isDisplay = machine.brick.isDisplay(a[5]) && a[6] == DisplaySize.WIDTH && a[7] == DisplaySize.HEIGHT
    if (isDisplay) {
        machine.brick.nxt.bitBlt(source, part, machine.lineOf(thread), machine.fileOf(thread))
    } else {
        part.draw(source, target)
    }
}

/** The array [array] as a picture; null, after throwing, if it has too few bytes. */
private fun picture(machine: VirtualMachine, thread: VmThread, array: Int, width: Int, height: Int): Picture? {
    val rows = (height.toLong() + ROW - 1) / ROW
    val bytes = if (width <= 0 || height <= 0) 0 else (width * rows).coerceAtMost(Int.MAX_VALUE.toLong()).toInt()
    if (!hasPart(machine, thread, array, 0, bytes)) return null
    return Picture(machine.brick.memory(array), maxOf(0, width), maxOf(0, height))
}

private const val BIT_BLT_ARGUMENTS = 13
private const val ROW = 8
private const val MOST_DOTS = 0xFFFF
