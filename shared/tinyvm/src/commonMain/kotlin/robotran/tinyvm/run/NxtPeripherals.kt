package robotran.tinyvm.run

import robotran.nxt.display.DisplayMemory
import robotran.nxt.display.DisplaySize
import robotran.nxt.hardware.EventTable
import robotran.nxt.hardware.EventView
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.link.LinkedField

/** The NXT around the machine. */
internal class NxtPeripherals(val nxt: Nxt) : Peripherals {
    private lateinit var machine: VirtualMachine
    private val events = EventTable()
    private val view = View()

    /** The objects of the events that are looked for, by their numbers; 0 for none. */
    private val registered = IntArray(EventTable.CAPACITY)
    private var display = 0
    private var font = 0

    override val milliseconds: Long get() = nxt.milliseconds

    override val wakesAt: Long? get() = events.nextLook

    override fun attach(machine: VirtualMachine) {
        this.machine = machine
        nxt.onStopRequest = { if (!delaysEnd()) machine.isExited = true }
    }

    override fun poll() = events.poll(view) { number, bits -> happen(registered[number], bits) }

    override fun roots(mark: (Int) -> Unit) {
        registered.forEach(mark)
        mark(display)
        mark(font)
    }

    override fun forget(isGone: (Int) -> Boolean) = Unit

    override fun delaysEnd(): Boolean {
        if (!events.has(EventTable.SYSTEM)) return false
        view.isToEnd = true
        return true
    }

    /** Performs [call], which [thread] makes, and returns its result. */
    fun call(thread: VmThread, call: NxtCall): Int = nxt.call(call, machine.lineOf(thread), machine.fileOf(thread))

    /** The array of [type] that is the display's memory; 0 if there is no memory for it. */
    fun display(type: ArrayType): Int {
        if (display == 0) {
            display = machine.newArray(type, DisplaySize.BYTES)
            if (display != 0) nxt.displayMemory = memory(display)
        }
        return display
    }

    /** The array of [type] with the font; 0 if there is no memory for it. */
    fun font(type: ArrayType, bytes: () -> ByteArray): Int {
        if (font != 0) return font
        val glyphs = bytes()
        font = machine.newArray(type, glyphs.size)
        if (font != 0) {
            for (index in glyphs.indices) {
                machine.heap.words[font + Heap.HEADER_WORDS + index] =
                    glyphs[index].toInt()
            }
        }
        return font
    }

    /** Whether [array] is the display's memory. */
    fun isDisplay(array: Int): Boolean = array == display

    /** The bytes of the Java array [array] as a picture. */
    fun memory(array: Int): DisplayMemory = HeapMemory(machine.heap.words, array + Heap.HEADER_WORDS)

    /** Looks for what the fields of [event] say from now on; returns its number, or below 0 if there is no room. */
    fun register(event: Int): Int {
        val known = registered.indexOf(event)
        if (known >= 0) return known
        val number = events.register(word(event, "type"), word(event, "filter"), word(event, "period"), view)
        if (number >= 0) registered[number] = event
        return number
    }

    /** Looks for [event] no more; returns below 0 if nobody did. */
    fun unregister(event: Int): Int {
        val number = registered.indexOf(event)
        if (number < 0) return -1
        events.unregister(number)
        registered[number] = 0
        return 0
    }

    private fun happen(event: Int, bits: Int) {
        val field = field(event, "happened", "I") ?: return
        val place = event + Heap.HEADER_WORDS + field.slot
        machine.heap.words[place] = machine.heap.words[place] or bits
        val monitor = field(event, "monitor", "Ljava/lang/Object;") ?: return
        machine.scheduler.notify(machine.heap.words[event + Heap.HEADER_WORDS + monitor.slot], all = true)
    }

    private fun word(event: Int, name: String): Int {
        val field = field(event, name, "I") ?: return 0
        return machine.heap.words[event + Heap.HEADER_WORDS + field.slot]
    }

    private fun field(event: Int, name: String, descriptor: String): LinkedField? =
        (machine.heap.typeOf(event) as LinkedClass).findField(name, descriptor, isStatic = false)

    private inner class View : EventView {
        override var isToEnd = false
        override val milliseconds: Long get() = nxt.milliseconds

        override fun analog(port: Int): Int = nxt.analog(port)

        override fun buttons(): Int = nxt.buttons()
    }
}

/** The bytes in [words] from [start] on. */
private class HeapMemory(private val words: IntArray, private val start: Int) : DisplayMemory {
    override fun get(index: Int): Int = words[start + index] and BYTE

    override fun set(index: Int, byte: Int) {
        words[start + index] = byte.toByte().toInt()
    }

    private companion object {
        const val BYTE = 0xFF
    }
}

/** The NXT, for native methods that only its class library has. */
internal val VirtualMachine.brick: NxtPeripherals get() = peripherals as NxtPeripherals
