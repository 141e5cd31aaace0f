package robotran.ecj;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFileReader;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFormatException;
import org.eclipse.jdt.internal.compiler.env.INameEnvironment;
import org.eclipse.jdt.internal.compiler.env.NameEnvironmentAnswer;

/** The class files that programs are compiled against. Each is read once, when it is first asked for. */
public final class Library implements INameEnvironment {
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

    private NameEnvironmentAnswer find(String name) {
        NameEnvironmentAnswer known = answers.get(name);
        byte[] file = files.get(name);
        if (known != null || file == null) {
            return known;
        }
        try {
            NameEnvironmentAnswer answer = new NameEnvironmentAnswer(new ClassFileReader(file, (name + ".class").toCharArray()), null);
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
