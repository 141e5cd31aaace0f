package robotran.tinyvm.link

import robotran.tinyvm.classfile.CodeEntry
import robotran.tinyvm.classfile.DamagedClassFile
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.messages.LinkMessages
import robotran.tinyvm.messages.UnsupportedFeature

/**
 * Follows all paths through a method and infers the type of each local and operand before each instruction. Verified
 * code cannot leave its stack, take a number for a reference, access an object of another class, or run past the end of
 * the code.
 */
internal class Verifier(
    private val method: LinkedMethod,
    private val entry: CodeEntry,
    private val types: TypeTable,
    private val messages: LinkMessages,
    private val budget: VerifierBudget,
) {
    private val relations = TypeRelations(types)
    private val code = ResolvedCode(entry.bytes.size)
    private val transferFunctions = TransferFunctions(method, types, relations, messages, code, types.model.isExact)
    private val contexts = SubroutineContexts()
    private val instructions = InstructionReader(entry, messages, types.model.isExact, ::locationOf).read()
    private val frameStates = HashMap<Int, FrameState>()
    private val worklist = ArrayDeque<Int>()
    private val isQueued = HashSet<Int>()
    private val handlers = entry.handlers.map { handler ->
        handler to (handler.catchType?.let { types.classNamed(it, locationOf(handler.target)) } ?: types.throwable)
    }

    private val frameStateWords = entry.maxLocals + entry.maxStack + 1
    private var currentPosition = 0

    /** Returns the resolved code; rejects the method if it is unsound. */
    fun verify(): ResolvedCode {
        try {
            mergeInto(0, SubroutineContexts.NONE, initialFrameState())
            while (worklist.isNotEmpty()) {
                val key = worklist.removeFirst()
                isQueued -= key
                currentPosition = key % entry.bytes.size
                follow(currentPosition, key / entry.bytes.size, frameStates.getValue(key).copy())
            }
            if (!types.model.isExact) findEarlyHandlers()
        } catch (_: UnsoundCode) {
            locationOf(currentPosition).unsound(messages)
        } catch (_: DamagedClassFile) {
            locationOf(currentPosition).unsound(messages)
        }
        return code
    }

    private fun follow(place: Int, context: Int, frameState: FrameState) {
        val instruction = instructions[place] ?: unsound()
        code.reached[place] = instruction
        code.depths[place] = frameState.depth
        for ((handler, type) in handlers) {
            if (place in handler.start until handler.end) {
                mergeInto(handler.target, context, frameState.caught(VerificationType.reference(type)))
            }
        }
        when (instruction.opcode) {
            Opcode.JSR -> {
                val inner = contexts.enter(context, instruction.next)
                    ?: locationOf(place).reject(messages.unsupportedFeature(UnsupportedFeature.NESTED_FINALLY))
                frameState.push(VerificationType.returnAddress(inner))
                mergeInto(instruction.operand, inner, frameState)
            }

            Opcode.RET -> {
                val address = frameState.local(instruction.operand)
                if (!VerificationType.isReturnAddress(address)) unsound()
                mergeInto(contexts.returnPosition(-address), contexts.outer(-address), frameState)
            }

            else -> {
                transferFunctions.apply(instruction, frameState, locationOf(place))
                followSuccessors(instruction, context, frameState)
            }
        }
    }

    private fun followSuccessors(instruction: Instruction, context: Int, frameState: FrameState) {
        val opcode = instruction.opcode
        val isBranch = opcode in Opcode.IFEQ..Opcode.GOTO || opcode == Opcode.IFNULL || opcode == Opcode.IFNONNULL
        val isSwitch = instruction.targets != null
        if (isBranch || isSwitch) mergeInto(instruction.operand, context, frameState)
        instruction.targets?.distinct()?.forEach { mergeInto(it, context, frameState) }
        val isEnd =
            isSwitch || opcode == Opcode.GOTO || opcode in Opcode.IRETURN..Opcode.RETURN || opcode == Opcode.ATHROW
        if (!isEnd) mergeInto(instruction.next, context, frameState)
    }

    private fun mergeInto(place: Int, context: Int, frameState: FrameState) {
        if (place !in entry.bytes.indices || instructions[place] == null) unsound()
        if (!budget.spend(
                frameStateWords,
            )
        ) {
            locationOf(place).reject(messages.unsupportedFeature(UnsupportedFeature.FAR_JUMP))
        }
        val key = context * entry.bytes.size + place
        val known = frameStates[key]
        if (known == null) {
            if (frameStates.size > TinyVmLimits.FRAME_STATE_WORDS / frameStateWords) {
                locationOf(place).reject(messages.unsupportedFeature(UnsupportedFeature.NESTED_FINALLY))
            }
            frameStates[key] = frameState.copy()
        } else if (!known.merge(frameState, relations)) {
            return
        }
        if (isQueued.add(key)) worklist.addLast(key)
    }

    /**
     * Finds the handlers that on a brick serve the instruction before theirs, too. They need the locals that they may use
     * there already; the rare one without them serves only its own instructions.
     */
    private fun findEarlyHandlers() {
        val places = code.reached.indices.filter { code.reached[it] != null }.groupBy { code.reached[it]?.next }
        for ((handler, type) in handlers) {
            val place = places[handler.start]?.single() ?: continue
            val length = code.reached[place]?.let { EarlyHandlers.lengthOf(it, place) } ?: continue
            val isSound = frameStates.filterKeys { it % entry.bytes.size == place }.all { (key, state) ->
                val known = frameStates[key - place + handler.target]
                known != null && !known.copy().merge(state.caught(VerificationType.reference(type)), relations)
            }
            if (isSound) code.earlyHandlers[handler] = length
        }
    }

    private fun initialFrameState(): FrameState {
        val frameState = FrameState(IntArray(entry.maxLocals), IntArray(entry.maxStack), 0)
        var slot = 0
        if (!method.isStatic) frameState.setLocal(slot++, VerificationType.reference(method.owner))
        for (parameter in method.types.parameters) {
            val isReference = isReferenceDescriptor(parameter)
            val value = if (isReference) {
                VerificationType.reference(
                    types.typeOf(parameter, locationOf(0)),
                )
            } else {
                VerificationType.ofLetter(parameter[0])
            }
            frameState.setLocal(slot, value)
            slot += if (VerificationType.isWide(value)) 2 else 1
        }
        return frameState
    }

    private fun locationOf(place: Int) = CodeLocation(method.owner.name, method.name, entry.lines.lineAt(place))
}
