package robotran.javacompiler.diagnose

import robotran.javacompiler.messages.JavaMessages

/**
 * Code for what computers have and an NXT with leJOS NXJ lacks: by the name of a member with its class, what a program
 * writes instead. It is the same in all languages. Where several ways are there, ` ~ ` is between them.
 */
private val CODE: Map<String, String> = buildMap {
    fun put(owners: String, vararg members: Pair<String, String>) = owners.split(' ').forEach { owner ->
        members.forEach { (names, code) -> names.split(' ').forEach { put("$owner.$it", code) } }
    }
    put(
        "LinkedList",
        "addFirst offerFirst push" to "list.add(0, element)",
        "addLast offerLast offer" to "list.add(element)",
        "getFirst peekFirst peek element" to "list.get(0)",
        "getLast peekLast" to "list.get(list.size() - 1)",
        "removeFirst pollFirst poll pop" to "list.remove(0)",
        "removeLast pollLast" to "list.remove(list.size() - 1)",
    )
    put(
        "Vector Stack Queue",
        "add" to "vector.addElement(element) ~ vector.insertElementAt(element, index)",
        "addAll" to "vector.addElement(element)",
        "get" to "vector.elementAt(index)",
        "set" to "vector.setElementAt(element, index)",
        "remove" to "vector.removeElementAt(index) ~ vector.removeElement(element)",
        "contains" to "vector.indexOf(element) >= 0",
        "firstElement" to "vector.elementAt(0)",
        "lastElement" to "vector.elementAt(vector.size() - 1)",
        "copyInto" to "vector.toArray(array)",
        "iterator listIterator" to "vector.elements()",
        "forEach stream removeIf replaceAll" to EACH_ELEMENT,
    )
    put(
        "Queue",
        "offer add" to "queue.push(element)",
        "element" to "queue.peek()",
        "poll remove" to "queue.pop()",
    )
    put(
        "Hashtable Properties",
        "containsKey contains" to "table.get(key) != null",
        "remove" to "table.put(key, null)",
        "isEmpty" to "!table.keys().hasMoreElements()",
        "keySet elements values entrySet size" to
            "for (Enumeration<String> keys = table.keys(); keys.hasMoreElements();) { }",
    )
    put("String", "endsWith" to "text.startsWith(end, text.length() - end.length())")
    put(
        "StringBuilder StringBuffer",
        "reverse" to "for (int i = text.length() - 1; i >= 0; i--) { back = back + text.charAt(i); }",
    )
    put("Integer Long", "signum" to "Math.signum(number)")
    put("Byte Short", "compareTo" to "a.intValue() - b.intValue()")
    put("Random", "setSeed" to "new Random(seed)", "nextBytes" to "(byte) random.nextInt()")
    put("Runtime", "gc" to "System.gc()")
    put(
        "NXTRegulatedMotor",
        "stalled" to "motor.isStalled()",
        "limitAngle" to "motor.getLimitAngle()",
        "stallLimit stallTime" to "motor.setStallThreshold(degrees, milliseconds)",
        "reg cont" to "motor.setSpeed(degrees)",
    )
    put("Button", "waitForAnyEvent" to "Button.waitForAnyEvent(0)")
    put("NXT", "exit" to "System.exit(0)")
    put("ADSensorPort", "readValues" to "port.readValue()", "readRawValues" to "port.readRawValue()")
    put("RConsole", "openOutputStream openPrintStream" to "RConsole.getPrintStream()")
    put("RConsole", "println" to "RConsole.println(\"\")")
    put("Bluetooth", "connect" to "Bluetooth.connect(device) ~ Bluetooth.connect(name, NXTConnection.PACKET)")
    put("DataOutput", "write" to "out.write(bytes, 0, bytes.length)")
    put("StringTokenizer", "nextToken" to "new StringTokenizer(text, sign)")
}

/** Goes through a list that a `for` with a colon cannot go through. */
internal const val EACH_ELEMENT = "for (int i = 0; i < vector.size(); i++) { }"

/** What to write instead of the member [name] of [owner], with the code for it; null if there is none. */
internal fun nxjCode(name: String, owner: String, messages: JavaMessages): String? =
    CODE["$owner.$name"]?.split(" ~ ")?.let(messages::writeInNxj)

/** The members of this table with their classes. */
internal val namesWithNxjCode: Set<String> get() = CODE.keys

/**
 * That leJOS NXJ lacks a member, and what to write instead, in one text.
 *
 * @param owner the simple name of the class.
 * @param member a method or constructor as name and descriptor; a field as name, colon and descriptor.
 */
fun missingInNxj(owner: String, member: String, messages: JavaMessages): String {
    val name = member.substringBefore('(').substringBefore(':')
    val explanation = when {
        name == "<init>" -> messages.wrongConstructor(owner, parametersOf(member))
        '(' in member -> messages.unknownMethod(name, owner)
        else -> messages.unknownField(name, owner)
    }
    return listOfNotNull(explanation, NxjGaps(messages).instead(name, owner)).joinToString(" ")
}

/** The simple names of the parameters in the descriptor of a [constructor], such as `int, String`. */
private fun parametersOf(constructor: String): String =
    PARAMETER.findAll(constructor.substringAfter('(').substringBefore(')')).joinToString { found ->
        val type = found.value.trimStart('[')
        val name = BASE_TYPES[type] ?: type.removeSuffix(";").substringAfterLast('/')
        name + "[]".repeat(found.value.length - type.length)
    }

private val PARAMETER = Regex("""\[*(?:L[^;]+;|[ZBCSIJFD])""")

private val BASE_TYPES = mapOf(
    "Z" to "boolean",
    "B" to "byte",
    "C" to "char",
    "S" to "short",
    "I" to "int",
    "J" to "long",
    "F" to "float",
    "D" to "double",
)
