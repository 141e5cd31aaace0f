package robotran.tinyvm.link

import robotran.tinyvm.classfile.ClassFile
import robotran.tinyvm.classfile.ClassFileResult
import robotran.tinyvm.classfile.CodeEntry
import robotran.tinyvm.classfile.MemberKind
import robotran.tinyvm.classfile.MemberReference
import robotran.tinyvm.classfile.MethodEntry
import robotran.tinyvm.classfile.readClassFile
import robotran.tinyvm.diagnostic.MemberUse
import robotran.tinyvm.messages.TinyVmMessages

/** Finds what the class files of a program, which must link, name of the library. */
internal class MemberUses(program: Map<String, ByteArray>, private val messages: TinyVmMessages) {
    private val own: Map<String, ClassFile> = program.mapNotNull { (name, bytes) ->
        (readClassFile(bytes, name, messages) as? ClassFileResult.Success)?.classFile
    }.associateBy { it.name }

    /** All uses, class by class, each in the order of the code. */
    fun all(): List<MemberUse> = own.values.flatMap { file ->
        val types = (listOfNotNull(file.superName) + file.interfaces).map { use(file, null, 0, it) }
        types.filterNotNull() +
            file.methods.flatMap { method -> method.code?.let { inCode(file, method, it) }.orEmpty() }
    }

    private fun inCode(file: ClassFile, method: MethodEntry, code: CodeEntry): List<MemberUse> {
        val instructions = InstructionReader(code, messages) { CodeLocation(file.name, method.name) }.read()
        return instructions.filterNotNull().mapNotNull { instruction ->
            val line = code.lines.lineAt(instruction.place)
            when (instruction.opcode) {
                in MEMBER_OPCODES -> use(file, method, line, file.constants.member(instruction.operand))
                in TYPE_OPCODES -> use(file, method, line, file.constants.className(instruction.operand))
                else -> null
            }
        }
    }

    private fun use(file: ClassFile, method: MethodEntry?, line: Int, type: String): MemberUse? {
        val name = type.trimStart('[').removePrefix("L").removeSuffix(";").takeIf { type.startsWith("[") } ?: type
        return if (name in own) null else MemberUse(file.name, method?.name, line, file.sourceFile, name, "")
    }

    private fun use(file: ClassFile, method: MethodEntry, line: Int, member: MemberReference): MemberUse? {
        var owner = member.owner
        // What a class of the program does not declare comes from its superclass.
        while (own[owner]?.let { !it.declares(member) } == true) owner = own[owner]?.superName ?: return null
        if (owner in own) return null
        val separator = if (member.kind == MemberKind.FIELD) ":" else ""
        val name = member.name + separator + member.descriptor
        return MemberUse(file.name, method.name, line, file.sourceFile, owner, name)
    }

    private fun ClassFile.declares(member: MemberReference): Boolean = if (member.kind == MemberKind.FIELD) {
        fields.any { it.name == member.name && it.descriptor == member.descriptor }
    } else {
        methods.any { it.name == member.name && it.descriptor == member.descriptor }
    }

    private companion object {
        val MEMBER_OPCODES = (Opcode.GETSTATIC..Opcode.INVOKESTATIC) + Opcode.INVOKEINTERFACE
        val TYPE_OPCODES =
            setOf(Opcode.NEW, Opcode.ANEWARRAY, Opcode.MULTIANEWARRAY, Opcode.CHECKCAST, Opcode.INSTANCEOF)
    }
}
