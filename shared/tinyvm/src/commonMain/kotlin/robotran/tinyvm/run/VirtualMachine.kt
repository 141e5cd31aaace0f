package robotran.tinyvm.run

import robotran.brick.program.FailureFrame
import robotran.tinyvm.config.MachineModel
import robotran.tinyvm.config.NxtCosts
import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.QuirkHandling
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.link.HeapType
import robotran.tinyvm.link.InitialValue
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.link.LinkedField
import robotran.tinyvm.link.LinkedProgram
import robotran.tinyvm.messages.TinyVmRunMessages

/**
 * The state of a running program, without the interpreter.
 *
 * @param objectBytes the brick's bytes for objects.
 * @param allBytes the brick's bytes for the program and its objects.
 */
internal class VirtualMachine(
    val program: LinkedProgram,
    val peripherals: Peripherals,
    val model: MachineModel,
    messages: TinyVmRunMessages,
    objectBytes: Int,
    allBytes: Int,
) {
    private val threadsByReference = HashMap<Int, VmThread>()
    private val textReferences = IntArray(program.texts.size)

    private val classObjects = HashMap<HeapType, Int>()
    private val typesOfClassObjects = HashMap<Int, HeapType>()

    val heap = Heap(program.types, model, objectBytes)
    val statics = IntArray(program.staticWords)
    val isInitialized = BooleanArray(program.classes.size)
    val monitors = Monitors()
    val scheduler = Scheduler(monitors, model) { peripherals.milliseconds }
    val warnings = RuntimeWarnings(model, messages, program.bytes, allBytes)
    val stacks = ThreadStacks(this)

    /** Bytecodes left to execute; negative if the last one took longer than the rest. */
    var budget = 0

    /** The thread being executed. */
    var current: VmThread? = null

    /** Whether another thread gets a turn although the current one could continue. */
    var isYielding = false

    /** Called for an exception that the class library shows because nobody catches it. */
    var onFailure: (VmThread, Int) -> Unit = { _, _ -> }

    /** Whether the program has called `System.exit`. */
    var isExited = false

    // Created first, while there is certainly enough memory.
    private val mainThread =
        VmThread(heap.newObject(program.thread), VirtualMachineConstants.MAIN_PRIORITY, isMain = true)
    private val exceptions = IntArray(BuiltInException.entries.size)

    /** An object that the machine itself is about to use. */
    private var held = 0

    /** The upper half of the long or double that a native method returns; 0 on an RCX. */
    var highWord = 0

    val milliseconds: Long get() = peripherals.milliseconds

    init {
        peripherals.attach(this)
        for (kind in BuiltInException.of(model)) {
            if (!model.isExact || kind == BuiltInException.OUT_OF_MEMORY) {
                exceptions[kind.ordinal] = heap.newObject(program.exceptions[kind.ordinal])
            }
        }
        stacks.create(mainThread)
        // A brick has no values for constants: compilers write them where they are used.
        if (!model.hasQuirks) program.statics.forEach(::setInitialValue)
    }

    private fun setInitialValue(field: LinkedField) {
        when (val value = field.initialValue) {
            is InitialValue.Word -> statics[field.slot] = value.bits

            is InitialValue.Text -> {
                if (!model.isExact) {
                    statics[field.slot] = newText(value.text)
                } else if (field.isRead) {
                    statics[field.slot] = text(program.texts.indexOf(value.text))
                }
            }

            is InitialValue.Wide -> {
                statics[field.slot] = value.value.toInt()
                statics[field.slot + 1] = (value.value shr Int.SIZE_BITS).toInt()
            }

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

    fun addWarning(quirk: Quirk) {
        if (model.isExact && quirk !in QUIRKS_OF_NXT) return
        warnings.add(quirk, sourceLine, current?.let { fileOf(it) })
    }

    /**
     * The object of a built-in exception that [thread] throws. On an RCX it is created in advance, so throwing it takes no
     * memory; an exact machine does so only for [BuiltInException.OUT_OF_MEMORY], which it throws if there is none for
     * another.
     */
    fun exception(kind: BuiltInException, thread: VmThread): Int {
        val known = exceptions[kind.ordinal]
        if (known != 0 || !model.isExact) return known
        val made = newObject(program.exceptions[kind.ordinal])
        if (made == 0) return exceptions[BuiltInException.OUT_OF_MEMORY.ordinal]
        held = made
        val field = program.throwableCalls
        if (field != null) {
            val calls = stackTrace(thread, made)
            heap.words[made + Heap.HEADER_WORDS + field.slot] = calls
        }
        held = 0
        return made
    }

    /** Makes [thread] throw [kind] before its next operation. */
    fun raise(thread: VmThread, kind: BuiltInException) {
        thread.pending = exception(kind, thread)
    }

    /** Makes [thread], which has been chosen for a turn, throw `InterruptedException` if that is due. */
    fun raiseDueInterrupt(thread: VmThread) {
        if (!thread.isInterruptDue) return
        thread.isInterruptDue = false
        thread.isInterrupted = false
        raise(thread, BuiltInException.INTERRUPTED)
    }

    /**
     * A new array with the calls of [thread], the innermost first: the number of the method in the upper half, the byte in
     * it in the lower one. Calls of constructors of [thrown], and that which asks for the array there, are left out. 0 if
     * there is no memory.
     */
    fun stackTrace(thread: VmThread, thrown: Int): Int {
        val frames = thread.callStack.dropWhile { frame ->
            val isOfThrown = !frame.method.isStatic && thrown != 0 && thread.stack[frame.base] == thrown
            isOfThrown && (frame.method.isConstructor || frame.method.name == FILL_IN_STACK_TRACE)
        }
        charge(frames.size * NxtCosts.STACK_TRACE_CALL)
        val type = program.wholeNumbers ?: return 0
        val array = retryAfterCollection { heap.newArray(type, frames.size) }
        if (array == 0) return 0
        for ((index, frame) in frames.withIndex()) {
            heap.words[array + Heap.HEADER_WORDS + index] =
                (program.numberOf(frame.method) shl HALF_BITS) or frame.byte.coerceAtMost(LOW_HALF)
        }
        return array
    }

    /** Where [thread] is. */
    fun placeOf(thread: VmThread): UncaughtPlace {
        val calls = thread.callStack.map {
            val owner = it.method.owner
            val name = "${owner.sourceName.substringAfterLast('.')}.${it.method.name}"
            FailureFrame(program.numberOf(it.method), it.byte, name, it.line, owner.sourceFile)
        }
        return UncaughtPlace(lineOf(thread), fileOf(thread), calls)
    }

    /** The object that stands for [type], always the same one; 0 if there is no memory. */
    fun classObject(type: HeapType): Int {
        classObjects[type]?.let { return it }
        val classType = program.classType ?: return 0
        val made = newObject(classType)
        if (made == 0) return 0
        classObjects[type] = made
        typesOfClassObjects[made] = type
        val number = classType.instanceFields.firstOrNull()?.takeIf { it.descriptor == "I" }
        if (number != null) heap.words[made + Heap.HEADER_WORDS + number.slot] = program.numberOfType(type)
        return made
    }

    /** The type that the object [reference] of [classObject] stands for, null if it is another object. */
    fun typeOfClassObject(reference: Int): HeapType? = typesOfClassObjects[reference]

    /** A copy of the object or array [reference]; 0 if there is no memory. */
    fun copyOf(reference: Int): Int {
        val type = heap.typeOf(reference)
        val copy = when (type) {
            is LinkedClass -> newObject(type)
            is ArrayType -> retryAfterCollection { heap.newArray(type, heap.length(reference)) }
        }
        if (copy == 0) return 0
        val content = reference + Heap.HEADER_WORDS
        heap.words.copyInto(heap.words, copy + Heap.HEADER_WORDS, content, reference + heap.sizeOf(reference))
        return copy
    }

    /** Collects garbage now. */
    fun collectGarbage() {
        collect()
    }

    /** Starts the thread that runs main. */
    fun startMain() {
        threadsByReference[mainThread.reference] = mainThread
        start(mainThread)
    }

    /** What `main` gets: an empty array; null on an RCX. */
    fun mainArguments(): Int = program.texts1?.let { newArray(it, 0) } ?: 0

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

    /** Ends [thread] in the middle of what it does; no `finally` is executed. */
    fun cutOff(thread: VmThread) {
        while (thread.depth > 0) thread.pop()
        end(thread)
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
        if (!model.isExact && isTooDeep(type, stack, first, dimensions)) {
            addWarning(Quirk.DEEP_ARRAY)
            if (model.hasQuirks) return 0
        }
        return retryAfterCollection { fillArrays(type, stack, first, dimensions) }
    }

    /**
     * Returns the string constant [number], 0 if there is no memory. A brick creates a new object each time, an NXT, too;
     * forgiving mode always returns the same one.
     */
    fun text(number: Int): Int {
        if (model.quirks != QuirkHandling.WARN) return newText(program.texts[number])
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
        if (model.hasQuirks) character.code.toShort().toInt() else character.code

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
        return length !in 0..model.arrayElements
    }

    /** Calls [make], and once more after a garbage collection if memory ran out. Nothing is collected during [make]. */
    private inline fun retryAfterCollection(make: () -> Int): Int {
        val wordsBefore = heap.wordsTaken
        var made = make()
        if (made == 0 && !model.hasQuirks && collect()) made = make()
        if (made == 0 || heap.isTooMuchForBrick) addWarning(Quirk.HEAP_FULL)
        charge(((heap.wordsTaken - wordsBefore) / model.wordsInABytecode).toInt())
        return made
    }

    /**
     * Collects garbage; returns whether enough memory is free. In forgiving mode, that uses up the rest of the budget.
     */
    private fun collect(): Boolean {
        if (!model.isExact) budget = minOf(budget, 0)
        val isWorthIt = heap.collect { mark ->
            exceptions.forEach(mark)
            textReferences.forEach(mark)
            if (model.isExact) {
                for (field in program.statics) if (field.isReference) mark(statics[field.slot])
            } else {
                statics.forEach(mark)
            }
            peripherals.roots(mark)
            classObjects.values.forEach(mark)
            mark(held)
            monitors.locks.forEach(mark)
            for (thread in scheduler.threads) {
                mark(thread.reference)
                mark(thread.pending)
                mark(thread.awaitedLock)
                mark(thread.uncaught)
                thread.callStack.forEach { mark(it.lock) }
                for (place in 0 until thread.usedWords) mark(thread.stack[place])
            }
        }
        peripherals.forget { !heap.survivedCollection(it) }
        threadsByReference.keys.filter { it != 0 && !heap.survivedCollection(it) }.forEach { threadsByReference -= it }
        if (model.isExact) {
            charge((heap.wordsVisited / NxtCosts.COLLECTED_WORDS_IN_A_BYTECODE).toInt())
            if (heap.isNearlyFull) warnings.addNearlyFull(sourceLine, current?.let { fileOf(it) })
        }
        return isWorthIt
    }

    private companion object {
        const val FILL_IN_STACK_TRACE = "fillInStackTrace"
        const val HALF_BITS = 16
        const val LOW_HALF = 0xFFFF
        val QUIRKS_OF_NXT = setOf(Quirk.HEAP_FULL, Quirk.UNCHECKED_ELEMENT)
    }
}
