package robotran.tinyvm.run

import robotran.rcxrom.program.Rom
import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.link.InitialValue
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.link.LinkedProgram
import robotran.tinyvm.messages.RunMessages

/** All that a run of a program is made of, save what executes it. */
internal class VirtualMachine(val program: LinkedProgram, val rom: Rom, val mode: TinyVmMode, messages: RunMessages) {
    private val threadsByReference = HashMap<Int, VmThread>()
    private val textReferences = IntArray(program.texts.size)

    val heap = Heap(program.types, mode, TinyVmLimits.MEMORY_BYTES - program.bytes)
    val statics = IntArray(program.statics.size)
    val isReady = BooleanArray(program.classes.size)
    val monitors = Monitors()
    val scheduler = Scheduler(monitors) { rom.milliseconds }
    val arrays = ArrayAddresses(heap, rom.memory, ::charge)
    val remarks = RuntimeWarnings(mode, messages, program.bytes)
    val poller = Poller(this)

    /** Bytecodes that may still be executed; below 0 if the last one took longer than what was left. */
    var budget = 0

    /** The thread that is being executed. */
    var current: VmThread? = null

    /** Whether another thread is to have a turn though the current one could go on. */
    var isYielding = false

    /** Whether the program has ended itself. */
    var isExited = false

    // Made before anything else, while there is room for sure.
    private val mainReference = heap.newObject(program.thread)
    private val exceptions = IntArray(program.exceptions.size) { heap.newObject(program.exceptions[it]) }

    init {
        for (field in program.statics) {
            when (val value = field.initialValue) {
                is InitialValue.Word -> statics[field.slot] = value.bits
                is InitialValue.Text -> statics[field.slot] = newText(value.text)
                null -> continue
            }
        }
    }

    /** Counts work that takes as long as so many bytecodes, so that no single one of them takes for ever. */
    fun charge(bytecodes: Int) {
        budget -= bytecodes
    }

    /** The line of the program that the current thread is at, 0 if it is in none. */
    val sourceLine: Int get() = current?.let { lineOf(it) } ?: 0

    fun lineOf(thread: VmThread): Int = ownFrameOf(thread)?.line ?: 0

    /** The file that [lineOf] is in, null if the program has only one. */
    fun fileOf(thread: VmThread): String? = ownFrameOf(thread)?.method?.owner?.sourceFile

    private fun ownFrameOf(thread: VmThread): Frame? = thread.callStack.firstOrNull { it.method.owner.isOfProgram }

    fun remark(quirk: Quirk) = remarks.add(quirk, sourceLine, current?.let { fileOf(it) })

    /** The object of a built-in exception. It is made beforehand, so throwing it takes no memory. */
    fun exception(kind: BuiltInException): Int = exceptions[kind.ordinal]

    /** Lets [thread] throw [kind] before it does anything else. */
    fun raise(thread: VmThread, kind: BuiltInException) {
        thread.pending = exception(kind)
    }

    /** The thread that runs main, which is started. */
    fun startMain() {
        val main = VmThread(mainReference, VirtualMachineConstants.MAIN_PRIORITY, isMain = true)
        threadsByReference[mainReference] = main
        scheduler.start(main)
    }

    /** Ends [thread] and gives its stack back. */
    fun end(thread: VmThread) {
        scheduler.end(thread)
        if (!thread.isMain) heap.release(VirtualMachineConstants.BRICK_THREAD_BYTES)
    }

    /** The thread whose object is [reference], which need not be started. */
    fun threadOf(reference: Int): VmThread = threadsByReference.getOrPut(reference) {
        VmThread(
            reference,
            current?.priority ?: VirtualMachineConstants.MAIN_PRIORITY,
        )
    }

    /** A new instance of [type], 0 if there is no memory. */
    fun newObject(type: LinkedClass): Int = making { heap.newObject(type) }

    /** A new array, 0 if there is no memory or it would be too long. */
    fun newArray(type: ArrayType, length: Int): Int =
        if (isTooLong(length)) 0 else making { heap.newArray(type, length) }

    /** A new array of arrays of the lengths at [first] of [stack]; 0 if there is no memory. */
    fun newArrays(type: ArrayType, stack: IntArray, first: Int, dimensions: Int): Int {
        if ((first until first + dimensions).any { isTooLong(stack[it]) }) return 0
        return making { fillArrays(type, stack, first, dimensions) }
    }

    /**
     * The text with this [number] in the program: made anew each time on a brick, otherwise always the same. 0 if there
     * is no memory.
     */
    fun text(number: Int): Int {
        if (mode == TinyVmMode.BRICK) return newText(program.texts[number])
        if (textReferences[number] == 0) textReferences[number] = newText(program.texts[number])
        return textReferences[number]
    }

    /** What the text object [reference] says. */
    fun textOf(reference: Int): String {
        val characters = heap.words[reference + Heap.HEADER_WORDS + program.textField.slot]
        if (characters == 0) return ""
        return CharArray(heap.length(characters)) {
            heap.words[characters + Heap.HEADER_WORDS + it].toChar()
        }.concatToString()
    }

    private fun newText(text: String): Int = making {
        val characters = heap.newArray(program.characters, text.length)
        val reference = if (characters == 0) 0 else heap.newObject(program.text)
        if (reference != 0) {
            for (index in text.indices) heap.words[characters + Heap.HEADER_WORDS + index] = text[index].code
            heap.words[reference + Heap.HEADER_WORDS + program.textField.slot] = characters
        }
        reference
    }

    private fun fillArrays(type: ArrayType, stack: IntArray, first: Int, dimensions: Int): Int {
        val array = heap.newArray(type, stack[first])
        if (array == 0 || dimensions == 1) return array
        for (index in 0 until stack[first]) {
            val element = fillArrays(type.element as ArrayType, stack, first + 1, dimensions - 1)
            if (element == 0) return 0
            heap.words[array + Heap.HEADER_WORDS + index] = element
        }
        return array
    }

    private fun isTooLong(length: Int): Boolean {
        if (length > TinyVmLimits.BRICK_ARRAY_ELEMENTS) remark(Quirk.LONG_ARRAY)
        val longest = if (mode ==
            TinyVmMode.BRICK
        ) {
            TinyVmLimits.BRICK_ARRAY_ELEMENTS
        } else {
            TinyVmLimits.FORGIVING_ARRAY_ELEMENTS
        }
        return length !in 0..longest
    }

    /**
     * Does [make] again with the memory collected if there is too little at first. Nothing is collected in the middle
     * of it.
     */
    private inline fun making(make: () -> Int): Int {
        val wordsBefore = heap.wordsTaken
        var made = make()
        if (made == 0 && mode == TinyVmMode.FORGIVING && collect()) made = make()
        if (made == 0 || heap.isTooMuchForBrick) remark(Quirk.HEAP_FULL)
        charge(((heap.wordsTaken - wordsBefore) / VirtualMachineConstants.WORDS_IN_A_BYTECODE).toInt())
        return made
    }

    /** Collecting takes the rest of the time there is. */
    private fun collect(): Boolean {
        budget = minOf(budget, 0)
        val isWorthIt = heap.collect { mark ->
            exceptions.forEach(mark)
            textReferences.forEach(mark)
            statics.forEach(mark)
            mark(poller.reference)
            monitors.locks.forEach(mark)
            for (thread in scheduler.threads) {
                mark(thread.reference)
                mark(thread.pending)
                mark(thread.waitsFor)
                thread.callStack.forEach { mark(it.lock) }
                for (place in 0 until thread.usedWords) mark(thread.stack[place])
            }
        }
        arrays.forget { !heap.wasKept(it) }
        threadsByReference.keys.filter { it != 0 && !heap.wasKept(it) }.forEach { threadsByReference -= it }
        return isWorthIt
    }
}
