package robotran.lejoslinker.link

import robotran.lejoslinker.image.ConstantValue
import robotran.tinyvm.classfile.AccessFlag
import robotran.tinyvm.classfile.ClassFile
import robotran.tinyvm.classfile.CodeEntry
import robotran.tinyvm.classfile.ConstantPool
import robotran.tinyvm.classfile.MemberReference
import robotran.tinyvm.classfile.MethodEntry
import robotran.tinyvm.link.Opcode
import robotran.tinyvm.link.SpecialNumbers

/**
 * What a program needs of its classes and of the library, found from `main` on. A call of a method that subclasses may
 * override counts as a call of all methods of that name and descriptor. The firmware itself calls `main`, `run` and the
 * static initializers only. All instance fields stay, since the firmware knows the places of some.
 */
internal class UsedParts(private val files: ClassFiles, entryClasses: List<String>) {
    private val used = LinkedHashSet<String>()
    private val calledSignatures = HashSet<String>()
    private val methods = HashSet<MethodEntry>()
    private val statics = HashSet<Pair<String, String>>()
    private val values = LinkedHashSet<ConstantValue>()
    private val waiting = ArrayDeque<Pair<ClassFile, CodeEntry>>()

    /** The internal names of the classes, in the order in which they were found. Some may not be there. */
    val classes: Set<String> get() = used

    /** The texts and numbers that code loads, in the order in which they were found. */
    val constants: Set<ConstantValue> get() = values

    init {
        SpecialNumbers.CLASSES.forEach(::use)
        entryClasses.forEach(::use)
        callOverridable(RUN)
        for (entry in entryClasses) {
            val file = files.find(entry) ?: continue
            file.methods.find { it.signature == MethodSelector.MAIN }?.let { call(file, it) }
        }
        while (waiting.isNotEmpty()) {
            val (file, code) = waiting.removeFirst()
            CodeReferences(code).forEach { opcode, index -> follow(file.constants, opcode, index) }
            for (handler in code.handlers) handler.catchType?.let(::use)
        }
    }

    /** Whether [method] can be called. */
    fun has(method: MethodEntry): Boolean = method in methods

    /** Whether code reads or writes the static field [name] of the class [owner]. */
    fun hasStatic(owner: String, name: String): Boolean = owner to name in statics

    private fun follow(pool: ConstantPool, opcode: Int, index: Int) {
        when (opcode) {
            Opcode.LDC, Opcode.LDC2_W -> ConstantTable.valueOf(pool.constant(index), pool)?.let { values += it }
            Opcode.NEW, Opcode.CHECKCAST, Opcode.INSTANCEOF, Opcode.ANEWARRAY -> use(pool.className(index))
            Opcode.GETSTATIC, Opcode.PUTSTATIC -> useStatic(pool.member(index))
            Opcode.GETFIELD, Opcode.PUTFIELD -> use(pool.member(index).owner)
            Opcode.INVOKESTATIC, Opcode.INVOKESPECIAL -> callExactly(pool.member(index))

            Opcode.INVOKEVIRTUAL, Opcode.INVOKEINTERFACE -> {
                val member = pool.member(index)
                use(member.owner)
                declaring(member.owner) { file -> file.methods.any { it.signature == member.signature } }
                    ?.let { use(it.name) }
                callOverridable(member.signature)
            }
        }
    }

    /** Notes a class, with those above it and its static initializer. */
    private fun use(name: String) {
        if (name.startsWith("[") || !used.add(name)) return
        val file = files.find(name) ?: return
        file.superName?.let(::use)
        for (method in file.methods) {
            if (method.signature == INITIALIZER || method.signature in calledSignatures) call(file, method)
        }
    }

    private fun useStatic(member: MemberReference) {
        use(member.owner)
        val owner = declaring(member.owner) { file ->
            file.fields.any { it.isStatic && it.name == member.name && it.descriptor == member.descriptor }
        } ?: return
        use(owner.name)
        statics += owner.name to member.name
    }

    private fun callExactly(member: MemberReference) {
        use(member.owner)
        val owner = declaring(member.owner) { file -> file.methods.any { it.signature == member.signature } } ?: return
        use(owner.name)
        owner.methods.find { it.signature == member.signature }?.let { call(owner, it) }
    }

    private fun callOverridable(signature: String) {
        if (!calledSignatures.add(signature)) return
        for (name in used.toList()) {
            val file = files.find(name) ?: continue
            file.methods.find { it.signature == signature }?.let { call(file, it) }
        }
    }

    private fun call(owner: ClassFile, method: MethodEntry) {
        if (!methods.add(method)) return
        val code = method.code ?: return
        if (method.flags and AccessFlag.NATIVE == 0) waiting += owner to code
    }

    /** The class that declares what [isHere] looks for: [owner], one above it, or an interface of these. */
    private fun declaring(owner: String, isHere: (ClassFile) -> Boolean): ClassFile? {
        val above = LinkedHashMap<String, ClassFile>()
        val first = if (owner.startsWith("[")) SpecialNumbers.CLASSES.first() else owner
        var next: String? = first
        while (next != null && next !in above) {
            val file = files.find(next) ?: break
            above[next] = file
            next = file.superName
        }
        above.values.find(isHere)?.let { return it }
        val interfaces = ArrayDeque(above.values.flatMap { it.interfaces })
        val seen = HashSet<String>()
        while (interfaces.isNotEmpty()) {
            val name = interfaces.removeFirst()
            if (!seen.add(name)) continue
            val file = files.find(name) ?: continue
            if (isHere(file)) return file
            interfaces += file.interfaces
        }
        return null
    }

    private companion object {
        const val RUN = "run()V"
        const val INITIALIZER = "<clinit>()V"
    }
}

/** Name and descriptor together. */
private val MemberReference.signature: String get() = name + descriptor
