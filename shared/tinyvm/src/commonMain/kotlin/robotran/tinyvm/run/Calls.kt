package robotran.tinyvm.run

import robotran.tinyvm.config.NxtCosts
import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.TinyVmCosts
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.link.EarlyHandlers
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.link.Translator

/**
 * Enters and leaves methods, whose arguments and results are on the thread's stack, and finds exception handlers.
 *
 * @param natives by method number.
 * @param uncaught called for an exception that its thread does not catch, before the frames are removed.
 */
internal class Calls(
    private val machine: VirtualMachine,
    private val natives: Array<NativeMethod?>,
    private val uncaught: (VmThread, Int) -> Unit,
) {
    private val isExact = machine.model.isExact
    private val handlers = HandlerEntries(machine)

    /** What a native method takes, in bytecodes. */
    private val nativeCost = if (isExact) NxtCosts.NATIVE_METHOD else TinyVmCosts.NATIVE_METHOD

    /**
     * Calls [method] from [caller]. The arguments are the topmost operands; `next` of [caller] is after the call and
     * `top` after the arguments. If the method must wait for a monitor, `next` moves back by [callWords], so that the
     * call is repeated. [isVirtual] is true if the object's class has determined the method.
     */
    fun call(thread: VmThread, caller: Frame, method: LinkedMethod, callWords: Int, isVirtual: Boolean) {
        val first = caller.top - method.argumentWords
        val body = method.body
        val native = natives.getOrNull(method.number)
        when {
            body != null -> {
                val lock = lockOf(thread, method, first, isVirtual)
                if (lock != 0 && !machine.monitors.enter(lock, thread)) {
                    caller.next -= callWords
                    block(thread, lock)
                    return
                }
                caller.top = first
                if (!enter(thread, method, first, lock)) throwOverflow(thread)
            }

            native != null -> callNative(thread, caller, method, native, first)
            else -> throwNew(thread, BuiltInException.NO_SUCH_METHOD)
        }
    }

    /**
     * Starts [thread] with [method], whose only argument is [argument]; false if it waits for a monitor or has ended.
     */
    fun begin(thread: VmThread, method: LinkedMethod, argument: Int): Boolean {
        thread.stack[0] = argument
        val lock = lockOf(thread, method, 0, isVirtual = !thread.isMain)
        if (lock != 0 && !machine.monitors.enter(lock, thread)) {
            block(thread, lock)
            return false
        }
        if (method.body == null || !enter(thread, method, 0, lock)) {
            machine.end(thread)
            return false
        }
        return true
    }

    /** Makes [thread] wait for the monitor [lock]. */
    fun block(thread: VmThread, lock: Int) {
        thread.awaitedLock = lock
        thread.state = ThreadState.BLOCKED
    }

    /**
     * Leaves the innermost method with [words] result words on top of its operands. Leaving the first method ends the
     * thread.
     */
    fun leave(thread: VmThread, words: Int) {
        val frame = thread.frame
        val first = frame.top - words
        drop(thread, frame)
        if (thread.depth == 0) {
            machine.end(thread)
            return
        }
        val caller = thread.frame
        for (word in 0 until words) thread.stack[caller.top++] = thread.stack[first + word]
    }

    /**
     * Initializes [type]; the operation that needs it is executed again. In forgiving mode its superclasses come first,
     * one class per call. A brick initializes each of them when it is used itself. Source: leJOS `language.c`,
     * dispatch_static_initializer.
     */
    fun initialize(thread: VmThread, type: LinkedClass) {
        val above = generateSequence(type.superclass) { it.superclass }.filter { !machine.isInitialized[it.number] }
        if (type.initializer != null && above.any { it.isOfProgram && it.initializer != null }) {
            machine.addWarning(Quirk.LATE_INITIALIZER)
        }
        val uninitialized = if (machine.model.hasQuirks) type else above.lastOrNull() ?: type
        machine.isInitialized[uninitialized.number] = true
        val initializer = uninitialized.initializer ?: return
        if (initializer.body == null || !enter(thread, initializer, thread.frame.top, 0)) {
            throwOverflow(thread)
        }
    }

    /**
     * Throws what a call throws that the stack of [thread] has no room for. If a brick cannot create the array for a
     * larger stack, it throws two exceptions, one after the other: the second one at the beginning of the handler of the
     * first. Source: leJOS `language.c`, dispatch_special.
     */
    private fun throwOverflow(thread: VmThread) {
        val isFirstOfTwo = machine.model.hasQuirks && machine.stacks.hasFailedArray
        if (isFirstOfTwo) {
            throwNew(thread, BuiltInException.OUT_OF_MEMORY)
            if (thread.depth == 0) return
            thread.frame.top = thread.frame.base + thread.frame.method.maxLocals
        }
        val second = machine.exception(BuiltInException.STACK_OVERFLOW, thread)
        throwObject(thread, second, isAtHandler = isFirstOfTwo)
    }

    /** Throws the exception of this [kind]. */
    fun throwNew(thread: VmThread, kind: BuiltInException, entry: HandlerEntry = HandlerEntry.NORMAL) =
        throwObject(thread, machine.exception(kind, thread), entry = entry)

    /**
     * Continues at the handler for [exception], or ends the thread if there is none.
     *
     * @param isOfNative whether the exception comes out of a native method that the innermost frame has called.
     * @param isAtHandler whether the innermost frame is at the beginning of a handler, before its first instruction.
     * @param entry how a brick enters the handler.
     */
    fun throwObject(
        thread: VmThread,
        exception: Int,
        isOfNative: Boolean = false,
        isAtHandler: Boolean = false,
        entry: HandlerEntry = HandlerEntry.NORMAL,
    ) {
        machine.charge(thread.depth / TinyVmCosts.FRAMES_IN_A_BYTECODE)
        val frames = thread.callStack
        if (frames.indices.none {
                targetOf(frames[it], exception, isOfNative || it > 0, isAtHandler && it == 0) >= 0
            }
        ) {
            if (tellLibrary(thread, exception)) return
            uncaught(thread, if (thread.uncaught != 0) thread.uncaught else exception)
            while (thread.depth > 0) drop(thread, thread.frame)
            machine.end(thread)
            return
        }
        var isOfCall = isOfNative
        var isAtStart = isAtHandler
        while (true) {
            val frame = thread.frame
            val target = targetOf(frame, exception, isOfCall, isAtStart)
            if (target >= 0) {
                frame.next = target
                frame.top = frame.base + frame.method.maxLocals
                thread.stack[frame.top++] = handlers.given(thread, exception, entry)
                return
            }
            drop(thread, frame)
            isOfCall = true
            isAtStart = false
        }
    }

    /**
     * Lets the class library deal with [exception], which leaves the first method of [thread], before the next operation;
     * false if it has no method for that, or if the exception comes out of that method.
     */
    private fun tellLibrary(thread: VmThread, exception: Int): Boolean {
        if (machine.program.uncaughtHandler == null || thread.uncaught != 0) return false
        thread.uncaught = exception
        thread.uncaughtAt = machine.placeOf(thread)
        while (thread.depth > 0) drop(thread, thread.frame)
        thread.pending = exception
        return true
    }

    /** Calls what the class library has for the exception that has left the first method of [thread]. */
    fun beginUncaught(thread: VmThread) {
        val at = thread.uncaughtAt
        val handler = machine.program.uncaughtHandler
        thread.stack[0] = thread.uncaught
        thread.stack[1] = at?.methodNumber ?: 0
        thread.stack[2] = at?.byte ?: 0
        if (handler == null || !enter(thread, handler, 0, 0)) machine.end(thread)
    }

    /**
     * @param isOfCall whether the exception comes out of a method that [frame] has called.
     * @param isAtHandler whether [frame] is at the beginning of a handler. A brick's `try` contains its own end.
     */
    private fun targetOf(frame: Frame, exception: Int, isOfCall: Boolean, isAtHandler: Boolean): Int {
        val handlers = frame.body.handlers
        if (handlers.size > TinyVmCosts.WORDS_IN_A_BYTECODE) {
            machine.charge(handlers.size / TinyVmCosts.WORDS_IN_A_BYTECODE)
        }
        val at = if (isAtHandler) frame.next else frame.next - 1
        val pastEnd = if (isAtHandler) 1 else 0
        val early = if (isOfCall) EarlyHandlers.CALL else EarlyHandlers.SINGLE_BYTE
        for (index in handlers.indices step Translator.HANDLER_NUMBERS) {
            val isEarly = !isAtHandler && frame.next == handlers[index] && handlers[index + 4] == early
            if (!isEarly && (at < handlers[index] || at >= handlers[index + 1] + pastEnd)) continue
            val type = handlers[index + 3]
            if (type != Translator.CATCHES_ALL &&
                !machine.heap.typeOf(exception).isA(machine.program.types[type])
            ) {
                continue
            }
            if (isEarly && frame.method.owner.isOfProgram) machine.addWarning(Quirk.EARLY_HANDLER)
            if (!isEarly || machine.model.hasQuirks) return handlers[index + 2]
        }
        return -1
    }

    private fun callNative(thread: VmThread, caller: Frame, method: LinkedMethod, native: NativeMethod, first: Int) {
        if (!method.isStatic && thread.stack[first] == 0) {
            throwNew(thread, BuiltInException.NULL_POINTER)
            return
        }
        machine.charge(nativeCost)
        val result = native.call(machine, thread, first)
        caller.top = first
        if (thread.pending != 0 || thread.state == ThreadState.DEAD) return
        if (method.resultWords > 0) thread.stack[caller.top++] = result
        if (method.resultWords > 1) thread.stack[caller.top++] = machine.highWord
    }

    private fun enter(thread: VmThread, method: LinkedMethod, base: Int, lock: Int): Boolean {
        if (method.body == null) return false
        val words = method.frameWords
        var frame = thread.push(base, words)
        if (frame == null && machine.stacks.grow(thread, base, words)) frame = thread.push(base, words)
        if (frame == null) {
            if (lock != 0) machine.monitors.exit(lock, thread)
            return false
        }
        frame.begin(method, base, thread.stack)
        frame.lock = lock
        return true
    }

    private fun drop(thread: VmThread, frame: Frame) {
        if (frame.lock != 0) machine.monitors.exit(frame.lock, thread)
        thread.pop()
    }

    /** The monitor of the static methods of [type]. */
    private fun lockOf(type: LinkedClass): Int {
        val lock = if (isExact) machine.classObject(type) else 0
        return if (lock != 0) lock else -1 - type.number
    }

    /**
     * The monitor to enter for a call of [method], 0 for none. A brick looks at `synchronized` only in virtual calls.
     * Source: leJOS `language.c`, dispatch_virtual.
     */
    private fun lockOf(thread: VmThread, method: LinkedMethod, first: Int, isVirtual: Boolean): Int {
        if (!method.isSynchronized) return 0
        val lock = if (method.isStatic) lockOf(method.owner) else thread.stack[first]
        if (isVirtual || isExact) return lock
        val matters = method.owner.isOfProgram && !machine.monitors.isOwner(lock, thread)
        if (matters) machine.addWarning(Quirk.UNLOCKED_METHOD)
        return if (machine.model.hasQuirks) 0 else lock
    }
}
