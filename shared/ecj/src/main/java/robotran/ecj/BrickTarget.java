package robotran.ecj;

import java.util.Map;
import org.eclipse.jdt.internal.compiler.impl.CompilerOptions;

/** The system on a brick that programs are compiled for. */
public enum BrickTarget {
    /** leJOS on an RCX: Java 1.3, class files of version 45.3, with {@link BrickRules} and {@link LockRules}. */
    LEJOS_RCX(CompilerOptions.VERSION_1_3, CompilerOptions.VERSION_1_1),

    /**
     * leJOS NXJ on an NXT: class files of version 50. NXJ's own compiler takes Java 5. We take Java 6, because Java 5
     * refuses {@code @Override} on a method of an interface, which public programs have on each listener.
     */
    LEJOS_NXJ(CompilerOptions.VERSION_1_6, CompilerOptions.VERSION_1_6);

    private final String language;
    private final String classFiles;

    BrickTarget(String language, String classFiles) {
        this.language = language;
        this.classFiles = classFiles;
    }

    /** Whether the virtual machine lacks parts of Java, so that programs must keep its rules. */
    boolean hasRules() {
        return this == LEJOS_RCX;
    }

    /** Whether the virtual machine makes a new object at each use of a text, so that {@link TextComparisons} fail. */
    boolean copiesTexts() {
        return this == LEJOS_NXJ;
    }

    /**
     * Whether the code of a {@code finally} is copied to each end of its {@code try}, as class files of version 50 need
     * it; those of older versions have it once, as a subroutine.
     */
    boolean copiesFinally() {
        return this == LEJOS_NXJ;
    }

    /** Adds the settings of the language and the class files. */
    void addTo(Map<String, String> settings) {
        settings.put(CompilerOptions.OPTION_Source, language);
        settings.put(CompilerOptions.OPTION_Compliance, language);
        settings.put(CompilerOptions.OPTION_TargetPlatform, classFiles);
        if (copiesFinally()) {
            // ECJ's command line sets this by itself.
            settings.put(CompilerOptions.OPTION_InlineJsr, CompilerOptions.ENABLED);
        }
    }
}
