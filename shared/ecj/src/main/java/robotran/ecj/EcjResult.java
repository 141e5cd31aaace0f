package robotran.ecj;

import java.util.List;
import java.util.Map;

/** The result of {@link EcjCompiler#compile}. */
public final class EcjResult {
    private final Map<String, byte[]> classes;
    private final List<String> mainClasses;
    private final List<EcjProblem> problems;
    private final boolean crashed;

    EcjResult(Map<String, byte[]> classes, List<String> mainClasses, List<EcjProblem> problems, boolean crashed) {
        this.classes = classes;
        this.mainClasses = mainClasses;
        this.problems = problems;
        this.crashed = crashed;
    }

    /** The class files by internal name, in source order; only of sources without errors. */
    public Map<String, byte[]> classes() {
        return classes;
    }

    /** The classes with a {@code public static void main(String[])}. */
    public List<String> mainClasses() {
        return mainClasses;
    }

    public List<EcjProblem> problems() {
        return problems;
    }

    /** Whether the compiler failed with an internal error; the problems found before that are kept. */
    public boolean crashed() {
        return crashed;
    }
}
