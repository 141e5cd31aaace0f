import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/**
 * Compares the public API of two class libraries, package by package. See README.md for how to run it.
 *
 * <p>The API are the public classes and their public and protected fields, constructors and methods, as class files have
 * them, with their descriptors. A member that a class inherits from a class of the same library is there, too.
 * Static initialisers and what a compiler adds do not count.
 */
public class CompareApi {
    private static final int PUBLIC = 0x0001;
    private static final int PROTECTED = 0x0004;
    private static final int SYNTHETIC = 0x1000;

    /** A class: whether programs can use it, what is above it, and its members that programs can use. */
    private record Type(String name, boolean isVisible, List<String> above, Set<String> members) {
        String packageName() {
            int dot = name.lastIndexOf('.');
            return dot < 0 ? "" : name.substring(0, dot);
        }
    }

    /** What a package of the original has, and what is there of it here. */
    private static class Row {
        int classes;
        int classesHere;
        int members;
        int membersHere;
        int classesMore;
        int membersMore;
        final List<String> missing = new ArrayList<>();
        final List<String> more = new ArrayList<>();
    }

    public static void main(String[] arguments) throws IOException {
        List<String> files = Stream.of(arguments).filter(it -> !it.startsWith("--")).toList();
        boolean isTable = List.of(arguments).contains("--table");
        if (files.size() != 2) {
            System.err.println("Usage: java CompareApi.java [--table] ORIGINAL OURS, each a jar or a folder of classes");
            System.exit(2);
        }
        Map<String, Row> rows = compare(read(Path.of(files.get(0))), read(Path.of(files.get(1))));
        System.out.println("| package | classes | there | members | there | % | more classes | more members |");
        System.out.println("|---|---|---|---|---|---|---|---|");
        Row all = new Row();
        rows.forEach((name, row) -> {
            all.classes += row.classes;
            all.classesHere += row.classesHere;
            all.members += row.members;
            all.membersHere += row.membersHere;
            all.classesMore += row.classesMore;
            all.membersMore += row.membersMore;
            System.out.println(line("`" + name + "`", row));
        });
        System.out.println(line("all", all));
        if (isTable) return;
        rows.forEach((name, row) -> {
            row.missing.forEach(it -> System.out.println("missing " + it));
            row.more.forEach(it -> System.out.println("more " + it));
        });
    }

    private static String line(String name, Row row) {
        int percent = row.members == 0 ? 100 : 100 * row.membersHere / row.members;
        return "| " + name + " | " + row.classes + " | " + row.classesHere + " | " + row.members + " | "
            + row.membersHere + " | " + percent + " | " + row.classesMore + " | " + row.membersMore + " |";
    }

    private static Map<String, Row> compare(Map<String, Type> original, Map<String, Type> ours) {
        Map<String, Row> rows = new TreeMap<>();
        for (Type type : original.values()) {
            if (!type.isVisible()) continue;
            Row row = rows.computeIfAbsent(type.packageName(), it -> new Row());
            Type here = ours.get(type.name());
            boolean isHere = here != null && here.isVisible();
            Set<String> missing = new TreeSet<>(type.members());
            if (isHere) missing.removeAll(allMembers(here, ours));
            row.classes++;
            row.members += type.members().size();
            row.membersHere += type.members().size() - missing.size();
            if (isHere) row.classesHere++;
            if (!isHere) row.missing.add("class " + type.name());
            else if (!missing.isEmpty()) row.missing.add(type.name() + ": " + String.join(", ", missing));
        }
        for (Type type : ours.values()) {
            if (!type.isVisible()) continue;
            Row row = rows.computeIfAbsent(type.packageName(), it -> new Row());
            Type there = original.get(type.name());
            boolean isThere = there != null && there.isVisible();
            Set<String> more = new TreeSet<>(type.members());
            if (isThere) more.removeAll(allMembers(there, original));
            if (!isThere) row.classesMore++;
            row.membersMore += more.size();
            if (!isThere) row.more.add("class " + type.name());
            else if (!more.isEmpty()) row.more.add(type.name() + ": " + String.join(", ", more));
        }
        return rows;
    }

    /** The members of a class and those that it inherits; constructors are not inherited. */
    private static Set<String> allMembers(Type type, Map<String, Type> library) {
        Set<String> members = new TreeSet<>(type.members());
        for (String above : type.above()) {
            Type found = library.get(above);
            if (found == null || above.equals(type.name())) continue;
            allMembers(found, library).stream().filter(it -> !it.startsWith("<init>")).forEach(members::add);
        }
        return members;
    }

    private static Map<String, Type> read(Path place) throws IOException {
        Map<String, Type> types = new TreeMap<>();
        if (Files.isDirectory(place)) {
            try (Stream<Path> files = Files.walk(place)) {
                for (Path file : files.filter(it -> it.toString().endsWith(".class")).toList()) {
                    add(types, Files.readAllBytes(file));
                }
            }
        } else {
            try (ZipFile jar = new ZipFile(place.toFile())) {
                for (ZipEntry entry : (Iterable<ZipEntry>) jar.stream().map(it -> (ZipEntry) it)::iterator) {
                    if (!entry.getName().endsWith(".class")) continue;
                    try (InputStream in = jar.getInputStream(entry)) {
                        add(types, in.readAllBytes());
                    }
                }
            }
        }
        return types;
    }

    private static void add(Map<String, Type> types, byte[] file) throws IOException {
        Type type = new ClassFile(file).type();
        types.put(type.name(), type);
    }

    /** What the format of class files says of one class. */
    private static class ClassFile {
        private final DataInputStream in;
        private Object[] constants;

        ClassFile(byte[] bytes) {
            in = new DataInputStream(new ByteArrayInputStream(bytes));
        }

        Type type() throws IOException {
            in.skipBytes(8);
            readConstants();
            int access = in.readUnsignedShort();
            String name = className(in.readUnsignedShort());
            List<String> above = new ArrayList<>();
            int superclass = in.readUnsignedShort();
            if (superclass != 0) above.add(className(superclass));
            for (int i = in.readUnsignedShort(); i > 0; i--) above.add(className(in.readUnsignedShort()));
            Set<String> members = new TreeSet<>();
            readMembers(members, true);
            readMembers(members, false);
            int nested = nestedAccess(name);
            int own = nested < 0 ? access : nested;
            boolean isVisible = (own & (PUBLIC | PROTECTED)) != 0 && (access & SYNTHETIC) == 0;
            return new Type(name, isVisible, above, members);
        }

        private void readConstants() throws IOException {
            constants = new Object[in.readUnsignedShort()];
            for (int i = 1; i < constants.length; i++) {
                int tag = in.readUnsignedByte();
                switch (tag) {
                    case 1 -> constants[i] = in.readUTF();
                    case 7 -> constants[i] = in.readUnsignedShort();
                    case 8, 16, 19, 20 -> in.skipBytes(2);
                    case 15 -> in.skipBytes(3);
                    case 5, 6 -> {
                        in.skipBytes(8);
                        i++;
                    }
                    default -> in.skipBytes(4);
                }
            }
        }

        private String className(int index) {
            return ((String) constants[(Integer) constants[index]]).replace('/', '.');
        }

        /** Reads fields, whose type does not count, or methods, of which the parameters count. */
        private void readMembers(Set<String> members, boolean areFields) throws IOException {
            for (int i = in.readUnsignedShort(); i > 0; i--) {
                int access = in.readUnsignedShort();
                String name = (String) constants[in.readUnsignedShort()];
                String descriptor = (String) constants[in.readUnsignedShort()];
                skipAttributes();
                boolean isVisible = (access & (PUBLIC | PROTECTED)) != 0 && (access & SYNTHETIC) == 0;
                if (!isVisible || name.equals("<clinit>")) continue;
                members.add(areFields ? name : name + descriptor.substring(0, descriptor.indexOf(')') + 1));
            }
        }

        private void skipAttributes() throws IOException {
            for (int i = in.readUnsignedShort(); i > 0; i--) {
                in.skipBytes(2);
                in.skipNBytes(in.readInt());
            }
        }

        /** The access of a class within another, as the attribute InnerClasses has it; below 0 for others. */
        private int nestedAccess(String name) throws IOException {
            int found = -1;
            for (int i = in.readUnsignedShort(); i > 0; i--) {
                String attribute = (String) constants[in.readUnsignedShort()];
                int length = in.readInt();
                if (!attribute.equals("InnerClasses")) {
                    in.skipNBytes(length);
                    continue;
                }
                for (int j = in.readUnsignedShort(); j > 0; j--) {
                    String inner = className(in.readUnsignedShort());
                    in.skipBytes(2);
                    boolean isNamed = in.readUnsignedShort() != 0;
                    int access = in.readUnsignedShort();
                    if (inner.equals(name)) found = isNamed ? access : 0;
                }
            }
            return found;
        }
    }
}
