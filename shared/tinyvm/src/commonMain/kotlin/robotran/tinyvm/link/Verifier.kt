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
    private val effects = TransferFunctions(method, types, relations, messages, code)
    private val contexts = SubroutineContexts()
    private val instructions = InstructionReader(entry, messages, ::placeOf).read()
    private val situations = HashMap<Int, FrameState>()
    private val waiting = ArrayDeque<Int>()
    private val isWaiting = HashSet<Int>()
    private val handlers = entry.handlers.map { handler ->
        handler to (handler.catchType?.let { types.classNamed(it, placeOf(handler.target)) } ?: types.throwable)
    }

    private val situationWords = entry.maxLocals + entry.maxStack + 1
    private var followed = 0

    /** Returns the resolved code; rejects the method if it is unsound. */
    fun verify(): ResolvedCode {
        try {
            arrive(0, SubroutineContexts.NONE, firstSituation())
            while (waiting.isNotEmpty()) {
                val key = waiting.removeFirst()
                isWaiting -= key
                followed = key % entry.bytes.size
                follow(followed, key / entry.bytes.size, situations.getValue(key).copy())
            }
        } catch (_: UnsoundCode) {
            placeOf(followed).unsound(messages)
        } catch (_: DamagedClassFile) {
            placeOf(followed).unsound(messages)
        }
        return code
    }

    private fun follow(place: Int, context: Int, situation: FrameState) {
        val instruction = instructions[place] ?: unsound()
        code.reached[place] = instruction
        code.beginsStatement[place] = situation.depth == 0
        for ((handler, type) in handlers) {
            if (place in handler.start until handler.end) {
                arrive(handler.target, context, situation.caught(VerificationType.reference(type)))
            }
        }
        when (instruction.opcode) {
            Opcode.JSR -> {
                val inner = contexts.enter(context, instruction.next)
                    ?: placeOf(place).refuse(messages.lacks(UnsupportedFeature.NESTED_FINALLY))
                situation.push(VerificationType.returnAddress(inner))
                arrive(instruction.operand, inner, situation)
            }

            Opcode.RET -> {
                val address = situation.local(instruction.operand)
                if (!VerificationType.isReturnAddress(address)) unsound()
                arrive(contexts.returnPlace(-address), contexts.outer(-address), situation)
            }

            else -> {
                effects.apply(instruction, situation, placeOf(place))
                goOn(instruction, context, situation)
            }
        }
    }

    private fun goOn(instruction: Instruction, context: Int, situation: FrameState) {
        val opcode = instruction.opcode
        val isBranch = opcode in Opcode.IFEQ..Opcode.GOTO || opcode == Opcode.IFNULL || opcode == Opcode.IFNONNULL
        if (isBranch) arrive(instruction.operand, context, situation)
        val isEnd = opcode == Opcode.GOTO || opcode in Opcode.IRETURN..Opcode.RETURN || opcode == Opcode.ATHROW
        if (!isEnd) arrive(instruction.next, context, situation)
    }

    private fun arrive(place: Int, context: Int, situation: FrameState) {
        if (place !in entry.bytes.indices || instructions[place] == null) unsound()
        if (!budget.spend(situationWords)) placeOf(place).refuse(messages.lacks(UnsupportedFeature.FAR_JUMP))
        val key = context * entry.bytes.size + place
        val known = situations[key]
        if (known == null) {
            if (situations.size > TinyVmLimits.SITUATION_WORDS / situationWords) {
                placeOf(place).refuse(messages.lacks(UnsupportedFeature.NESTED_FINALLY))
            }
            situations[key] = situation.copy()
        } else if (!known.merge(situation, relations)) {
            return
        }
        if (isWaiting.add(key)) waiting.addLast(key)
    }

    private fun firstSituation(): FrameState {
        val situation = FrameState(IntArray(entry.maxLocals), IntArray(entry.maxStack), 0)
        var slot = 0
        if (!method.isStatic) situation.setLocal(slot++, VerificationType.reference(method.owner))
        for (parameter in method.types.parameters) {
            val isReference = isReferenceDescriptor(parameter)
            val value = if (isReference) {
                VerificationType.reference(
                    types.typeOf(parameter, placeOf(0)),
                )
            } else {
                VerificationType.ofLetter(parameter[0])
            }
            situation.setLocal(slot, value)
            slot += if (VerificationType.isWide(value)) 2 else 1
        }
        return situation
    }

    private fun placeOf(place: Int) = CodeLocation(method.owner.name, method.name, entry.lines.lineAt(place))
}
