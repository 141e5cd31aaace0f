package robotran.ecj;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFileConstants;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFileReader;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFormatException;
import org.eclipse.jdt.internal.compiler.env.IBinaryField;
import org.eclipse.jdt.internal.compiler.env.IBinaryMethod;
import org.eclipse.jdt.internal.compiler.env.IBinaryType;
import org.eclipse.jdt.internal.compiler.env.INameEnvironment;
import org.eclipse.jdt.internal.compiler.env.NameEnvironmentAnswer;

/** The class files that programs are compiled against. Each is parsed on first use. */
public final class Library {
    private final Map<String, byte[]> files = new HashMap<>();
    private final Map<String, NameEnvironmentAnswer> answers = new HashMap<>();
    private final Set<String> packages = new HashSet<>();

    /** @param name the class's internal name, such as {@code java/lang/Object} */
    public void add(String name, byte[] classFile) {
        files.put(name, classFile);
        for (int slash = name.indexOf('/'); slash >= 0; slash = name.indexOf('/', slash + 1)) {
            packages.add(name.substring(0, slash));
        }
    }

    /** Adapts the library to ECJ's interface. */
    INameEnvironment environment() {
        return new INameEnvironment() {
            @Override
            public NameEnvironmentAnswer findType(char[][] compoundName) {
                return find(joined(compoundName, null));
            }

            @Override
            public NameEnvironmentAnswer findType(char[] typeName, char[][] packageName) {
                return find(joined(packageName, typeName));
            }

            @Override
            public boolean isPackage(char[][] parentPackageName, char[] packageName) {
                return packages.contains(joined(parentPackageName, packageName));
            }

            @Override
            public void cleanup() {}
        };
    }

    /**
     * The names of the visible methods and fields of the class {@code simpleName}, in any package, and of its
     * superclasses.
     */
    List<String> memberNames(String simpleName) {
        Set<String> names = new TreeSet<>();
        String next = null;
        for (String file : new TreeSet<>(files.keySet())) {
            next = file.substring(file.lastIndexOf('/') + 1).equals(simpleName) ? file : next;
        }
        // The counter ends the loop even if superclasses form a cycle.
        for (int left = files.size(); next != null && left > 0; left--) {
            NameEnvironmentAnswer answer = find(next);
            if (answer == null) {
                break;
            }
            IBinaryType type = answer.getBinaryType();
            addNames(type, names);
            next = type.getSuperclassName() == null ? null : new String(type.getSuperclassName());
        }
        return new ArrayList<>(names);
    }

    private static void addNames(IBinaryType type, Set<String> names) {
        if (type.getMethods() != null) {
            for (IBinaryMethod method : type.getMethods()) {
                if (!method.isConstructor() && !method.isClinit() && isOpen(method.getModifiers())) {
                    names.add(new String(method.getSelector()));
                }
            }
        }
        if (type.getFields() != null) {
            for (IBinaryField field : type.getFields()) {
                if (isOpen(field.getModifiers())) {
                    names.add(new String(field.getName()));
                }
            }
        }
    }

    private static boolean isOpen(int modifiers) {
        return (modifiers & (ClassFileConstants.AccPublic | ClassFileConstants.AccProtected)) != 0;
    }

    private NameEnvironmentAnswer find(String name) {
        NameEnvironmentAnswer known = answers.get(name);
        byte[] file = files.get(name);
        if (known != null || file == null) {
            return known;
        }
        try {
            NameEnvironmentAnswer answer = new NameEnvironmentAnswer(
                new ClassFileReader(file, (name + ".class").toCharArray()), null);
            answers.put(name, answer);
            return answer;
        } catch (ClassFormatException malformed) {
            throw new IllegalArgumentException("The library's " + name + " is no class file.", malformed);
        }
    }

    private static String joined(char[][] packageName, char[] name) {
        StringBuilder joined = new StringBuilder();
        if (packageName != null) {
            for (char[] part : packageName) {
                joined.append(joined.length() == 0 ? "" : "/").append(part);
            }
        }
        if (name != null) {
            joined.append(joined.length() == 0 ? "" : "/").append(name);
        }
        return joined.toString();
    }
}
