package robotran.tinyvm.run

import robotran.rcxrom.program.Rom
import robotran.tinyvm.config.BrickRoom
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.TinyVmCosts
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.link.InitialValue
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.link.LinkedField
import robotran.tinyvm.link.LinkedProgram
import robotran.tinyvm.messages.RunMessages

/** The state of a running program, without the interpreter. */
internal class VirtualMachine(
    val program: LinkedProgram,
    val rom: Rom,
    val mode: TinyVmMode,
    messages: RunMessages,
    version: LejosVersion,
) {
    private val threadsByReference = HashMap<Int, VmThread>()
    private val textReferences = IntArray(program.texts.size)

    val heap = Heap(program.types, mode, BrickRoom.of(version).objectBytes(program.bytes))
    val statics = IntArray(program.statics.size)
    val isInitialized = BooleanArray(program.classes.size)
    val monitors = Monitors()
    val scheduler = Scheduler(monitors) { rom.milliseconds }
    val arrays = ArrayAddresses(heap, rom.memory, ::charge)
    val region = HeapRegion(heap, rom.memory, arrays)
    val remarks = RuntimeWarnings(mode, messages, program.bytes, BrickRoom.of(version).bytes)
    val poller = Poller(this)
    val stacks = ThreadStacks(this)

    /** Bytecodes left to execute; negative if the last one took longer than the rest. */
    var budget = 0

    /** The thread being executed. */
    var current: VmThread? = null

    /** Whether another thread gets a turn although the current one could continue. */
    var isYielding = false

    /** Whether the program has called `System.exit`. */
    var isExited = false

    // Created first, while there is certainly enough memory.
    private val mainThread =
        VmThread(heap.newObject(program.thread), VirtualMachineConstants.MAIN_PRIORITY, isMain = true)
    private val exceptions = IntArray(program.exceptions.size) { heap.newObject(program.exceptions[it]) }

    init {
        stacks.create(mainThread)
        // A brick has no values for constants: compilers write them where they are used.
        if (mode == TinyVmMode.FORGIVING) program.statics.forEach(::setInitialValue)
    }

    private fun setInitialValue(field: LinkedField) {
        when (val value = field.initialValue) {
            is InitialValue.Word -> statics[field.slot] = value.bits
            is InitialValue.Text -> statics[field.slot] = newText(value.text)
            null -> return
        }
    }

    /** Charges work that takes as long as [bytecodes], so that no single bytecode takes unlimited time. */
    fun charge(bytecodes: Int) {
        budget -= bytecodes
    }

    /** The line of the program's own code that the current thread is at, 0 if unknown. */
    val sourceLine: Int get() = current?.let { lineOf(it) } ?: 0

    fun lineOf(thread: VmThread): Int = ownFrameOf(thread)?.line ?: 0

    /** The source file of [lineOf], null if the program has only one. */
    fun fileOf(thread: VmThread): String? = ownFrameOf(thread)?.method?.owner?.sourceFile

    private fun ownFrameOf(thread: VmThread): Frame? = thread.callStack.firstOrNull { it.method.owner.isOfProgram }

    fun addWarning(quirk: Quirk) = remarks.add(quirk, sourceLine, current?.let { fileOf(it) })

    /** The object of a built-in exception. It is created in advance, so throwing it takes no memory. */
    fun exception(kind: BuiltInException): Int = exceptions[kind.ordinal]

    /** Makes [thread] throw [kind] before its next operation. */
    fun raise(thread: VmThread, kind: BuiltInException) {
        thread.pending = exception(kind)
    }

    /** Starts the thread that runs main. */
    fun startMain() {
        threadsByReference[mainThread.reference] = mainThread
        start(mainThread)
    }

    /** Makes [thread] ready to run; its stack must be there already. */
    fun start(thread: VmThread) {
        scheduler.start(thread)
        setState(thread, VirtualMachineConstants.THREAD_STARTED)
    }

    /** Ends [thread] and releases its stack memory. */
    fun end(thread: VmThread) {
        setState(thread, VirtualMachineConstants.THREAD_DEAD)
        scheduler.end(thread)
        stacks.free(thread)
    }

    /** The thread of the object [reference]; it may not be started yet. */
    fun threadOf(reference: Int): VmThread = threadsByReference.getOrPut(reference) {
        VmThread(
            reference,
            current?.priority ?: VirtualMachineConstants.MAIN_PRIORITY,
        )
    }

    /** Returns a new instance of [type], 0 if there is no memory. */
    fun newObject(type: LinkedClass): Int = retryAfterCollection { heap.newObject(type) }

    /** Returns a new array, 0 if there is no memory or it would be too long. */
    fun newArray(type: ArrayType, length: Int): Int =
        if (isTooLong(length)) 0 else retryAfterCollection { heap.newArray(type, length) }

    /** Returns a new array of arrays; the lengths are in [stack] from index [first]. 0 if there is no memory. */
    fun newArrays(type: ArrayType, stack: IntArray, first: Int, dimensions: Int): Int {
        if ((first until first + dimensions).any { isTooLong(stack[it]) }) return 0
        if (isTooDeep(type, stack, first, dimensions)) {
            addWarning(Quirk.DEEP_ARRAY)
            if (mode == TinyVmMode.BRICK) return 0
        }
        return retryAfterCollection { fillArrays(type, stack, first, dimensions) }
    }

    /**
     * Returns the string constant [number], 0 if there is no memory. A brick creates a new object each time; forgiving
     * mode always returns the same one.
     */
    fun text(number: Int): Int {
        if (mode == TinyVmMode.BRICK) return newText(program.texts[number])
        if (textReferences[number] == 0) textReferences[number] = newText(program.texts[number])
        return textReferences[number]
    }

    /** The content of the string object [reference]. */
    fun textOf(reference: Int): String {
        val characters = heap.words[reference + Heap.HEADER_WORDS + program.textField.slot]
        if (characters == 0) return ""
        return CharArray(heap.length(characters)) {
            heap.words[characters + Heap.HEADER_WORDS + it].toChar()
        }.concatToString()
    }

    /** Sets the state that `Thread.isAlive` looks at. */
    private fun setState(thread: VmThread, state: Int) {
        val field = program.threadState ?: return
        heap.words[thread.reference + Heap.HEADER_WORDS + field.slot] = state
    }

    private fun newText(text: String): Int = retryAfterCollection {
        val characters = heap.newArray(program.characters, text.length)
        val reference = if (characters == 0) 0 else heap.newObject(program.text)
        if (reference != 0) {
            for (index in text.indices) heap.words[characters + Heap.HEADER_WORDS + index] = elementOf(text[index])
            heap.words[reference + Heap.HEADER_WORDS + program.textField.slot] = characters
        }
        reference
    }

    /** A brick reads the characters of an array as signed numbers. */
    private fun elementOf(character: Char): Int =
        if (mode == TinyVmMode.BRICK) character.code.toShort().toInt() else character.code

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

    /**
     * Whether a brick cannot create these arrays at once. It counts a length down while it creates the arrays of that
     * length, unless theirs is the innermost dimension of [type], so a second array of that length fails. Source: leJOS
     * `memory.c`, new_multi_array.
     */
    private fun isTooDeep(type: ArrayType, stack: IntArray, first: Int, dimensions: Int): Boolean {
        val innermost = type.descriptor.lastIndexOf('[')
        var arrays = 1
        for (dimension in 1 until minOf(dimensions, innermost)) {
            arrays *= stack[first + dimension - 1]
            if (arrays > 1) return true
        }
        return false
    }

    private fun isTooLong(length: Int): Boolean {
        if (length > TinyVmLimits.BRICK_ARRAY_ELEMENTS) addWarning(Quirk.LONG_ARRAY)
        val longest = if (mode == TinyVmMode.BRICK) {
            TinyVmLimits.BRICK_ARRAY_ELEMENTS
        } else {
            TinyVmLimits.FORGIVING_ARRAY_ELEMENTS
        }
        return length !in 0..longest
    }

    /** Calls [make], and once more after a garbage collection if memory ran out. Nothing is collected during [make]. */
    private inline fun retryAfterCollection(make: () -> Int): Int {
        val wordsBefore = heap.wordsTaken
        var made = make()
        if (made == 0 && mode == TinyVmMode.FORGIVING && collect()) made = make()
        if (made == 0 || heap.isTooMuchForBrick) addWarning(Quirk.HEAP_FULL)
        charge(((heap.wordsTaken - wordsBefore) / TinyVmCosts.WORDS_IN_A_BYTECODE).toInt())
        return made
    }

    /** Collects garbage, which uses up the rest of the budget; returns whether enough memory is free. */
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
                mark(thread.awaitedLock)
                thread.callStack.forEach { mark(it.lock) }
                for (place in 0 until thread.usedWords) mark(thread.stack[place])
            }
        }
        arrays.forget { !heap.survivedCollection(it) }
        threadsByReference.keys.filter { it != 0 && !heap.survivedCollection(it) }.forEach { threadsByReference -= it }
        return isWorthIt
    }
}
