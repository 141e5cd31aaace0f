package robotran.lejoslinker.link

import robotran.lejoslinker.config.ImageLimits
import robotran.lejoslinker.image.ConstantValue
import robotran.lejoslinker.image.FieldType
import robotran.lejoslinker.messages.classMissing
import robotran.lejoslinker.messages.tinyVm
import robotran.tinyvm.classfile.Constant
import robotran.tinyvm.classfile.ConstantPool
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.UnsupportedFeature

/**
 * The operands of instructions as in the image. What does not exist or fit is refused, and the operand is 0. Source:
 * leJOS `CodeUtilities.java`.
 *
 * @param refuse reports a mistake at the instruction that is being written.
 */
internal class OperandWriter(
    private val tables: LinkedTables,
    private val pool: ConstantPool,
    private val refuse: (String) -> Unit,
) {
    private val messages = tables.messages

    /** The number of the constant at [index] for `ldc`. */
    fun loadedConstant(index: Int, method: ImageMethod): Int {
        val constant = pool.constant(index)
        if (constant is Constant.ClassName) {
            return refused(messages.tinyVm.unsupportedFeature(UnsupportedFeature.CLASS_LITERAL))
        }
        val value = ConstantTable.valueOf(constant, pool) ?: return refused(messages.tinyVm.codeInvalid())
        if (value is ConstantValue.Text) check(value.text)
        val number = tables.constants.numberOf(value)
        if (number > ImageLimits.LOADED_CONSTANT) {
            refuseProgram(method, messages.tooManyConstants(tables.constants.size, ImageLimits.LOADED_CONSTANT + 1))
        }
        return number
    }

    /** The number of the constant at [index] for `ldc2_w`. */
    fun wideConstant(index: Int): Int = ConstantTable.valueOf(pool.constant(index), pool)
        ?.let { tables.constants.numberOf(it) } ?: refused(messages.tinyVm.codeInvalid())

    /** The number of the class at [index]. */
    fun classNumber(index: Int, isTest: Boolean): Int {
        val name = pool.className(index)
        return when {
            !name.startsWith("[") -> tables.hierarchy.classNamed(name)?.number ?: missing(name)
            isTest -> refused(messages.tinyVm.unsupportedFeature(UnsupportedFeature.ARRAY_TEST))
            else -> refused(messages.tinyVm.codeInvalid())
        }
    }

    /** Refuses a class at [index] that is not there. */
    fun checkClass(index: Int) {
        val name = pool.className(index)
        if (!name.startsWith("[") && tables.hierarchy.classNamed(name) == null) missing(name)
    }

    /** Class number and field number of the static field at [index]. */
    fun staticField(index: Int, method: ImageMethod): Int {
        val field = field(index, isStatic = true) ?: return 0
        if (field.number > ImageLimits.STATIC_FIELD) {
            refuseProgram(method, messages.tooManyStaticFields(tables.staticFieldCount, ImageLimits.STATIC_FIELD + 1))
        }
        return field.owner.number shl BYTE_BITS or field.number
    }

    /** Type and offset of the field at [index] in an object. */
    fun instanceField(index: Int): Int {
        val field = field(index, isStatic = false) ?: return 0
        return field.type.number shl OFFSET_BITS or field.offset
    }

    /** Class number and index of the method at [index], which is the one that is called. */
    fun exactMethod(index: Int): Int {
        val method = method(index) ?: return 0
        return method.owner.number shl BYTE_BITS or method.index
    }

    /** Words of the arguments and signature number of the method at [index], which subclasses may override. */
    fun virtualMethod(index: Int): Int {
        val method = method(index) ?: return 0
        return method.argumentWords shl OFFSET_BITS or method.signature
    }

    /**
     * Element type and dimensions of the array class at [index], of which [requested] are created. For arrays of arrays
     * of objects leJOS's linker writes 14, which lies outside the firmware's table of sizes.
     */
    fun arrayClass(index: Int, requested: Int): Int {
        val descriptor = pool.className(index)
        val dimensions = descriptor.takeWhile { it == '[' }.length
        if (dimensions == 0 || dimensions == descriptor.length || requested !in 1..dimensions) {
            return refused(messages.tinyVm.codeInvalid())
        }
        val type = FieldType.of(descriptor.drop(dimensions))
        if (type == FieldType.REFERENCE && requested == dimensions) return refused(messages.arraysOfObjectArrays())
        return (if (type == FieldType.REFERENCE) OBJECT_ELEMENTS else type.number) shl BYTE_BITS or dimensions
    }

    private fun check(text: String) {
        if (text.length > ImageLimits.TEXT_CHARACTERS) {
            refuse(messages.tinyVm.tooMany(Counted.TEXT_CHARACTERS, ImageLimits.TEXT_CHARACTERS))
        }
        val strange = text.find { it.code > ImageLimits.CHARACTER }
        if (strange != null) refuse(messages.strangeCharacter(strange.toString()))
    }

    private fun field(index: Int, isStatic: Boolean): ImageField? {
        val member = pool.member(index)
        val field = tables.hierarchy.field(member.owner, member.name, member.descriptor, isStatic)
        if (field == null) {
            refuseMember(member.owner, messages.tinyVm.fieldMissing(member.owner.replace('/', '.'), member.name))
        }
        return field
    }

    private fun method(index: Int): ImageMethod? {
        val member = pool.member(index)
        val method = tables.hierarchy.method(member.owner, member.name + member.descriptor)
        if (method == null) {
            refuseMember(member.owner, messages.tinyVm.methodMissing(member.owner.replace('/', '.'), member.name))
        }
        return method
    }

    /** Reports a mistake that the program makes as a whole: here if this is its own code, otherwise at its main class. */
    private fun refuseProgram(method: ImageMethod, message: String) {
        if (method.owner.isOwn) refuse(message) else tables.errors.add(tables.programPlace, message)
    }

    private fun missing(name: String) = refused(messages.classMissing(name))

    /** Reports a member that is not there with [message], unless the whole class [owner] is missing. */
    private fun refuseMember(owner: String, message: String) {
        val isThere = owner.startsWith("[") || tables.hierarchy.classNamed(owner) != null
        refuse(if (isThere) message else messages.classMissing(owner))
    }

    private fun refused(message: String): Int {
        refuse(message)
        return 0
    }

    private companion object {
        const val BYTE_BITS = 8
        const val OFFSET_BITS = 12

        /** What leJOS's linker writes for elements that are objects: the type number of its library for class files. */
        const val OBJECT_ELEMENTS = 14
    }
}
