package robotran.ecj;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.jdt.core.compiler.CategorizedProblem;
import org.eclipse.jdt.core.compiler.IProblem;
import org.eclipse.jdt.internal.compiler.ClassFile;
import org.eclipse.jdt.internal.compiler.CompilationResult;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFileReader;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFileConstants;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFormatException;
import org.eclipse.jdt.internal.compiler.env.IBinaryMethod;
import org.eclipse.jdt.internal.compiler.env.ICompilationUnit;
import org.eclipse.jdt.internal.compiler.impl.CompilerOptions;

/** The Eclipse compiler for Java in memory. It compiles sources to class files for a {@link BrickTarget}. */
public final class EcjCompiler {
    /** Max UTF-16 characters of all sources together, about fifty times what fits into a brick. */
    public static final int SOURCE_CHARACTERS = 200_000;

    public static final int SOURCES = 100;

    private static final List<String> WARNINGS = Arrays.asList(
            CompilerOptions.OPTION_ReportNoEffectAssignment,
            CompilerOptions.OPTION_ReportPossibleAccidentalBooleanAssignment,
            CompilerOptions.OPTION_ReportEmptyStatement,
            CompilerOptions.OPTION_ReportComparingIdentical,
            CompilerOptions.OPTION_ReportNullReference);

    private static final List<String> DEBUGGING = Arrays.asList(
            CompilerOptions.OPTION_LineNumberAttribute,
            CompilerOptions.OPTION_LocalVariableAttribute,
            CompilerOptions.OPTION_SourceFileAttribute);

    /** The problems with names that a class does not have, or with its constructors. */
    private static final List<Integer> NAMES_OF_MEMBERS = Arrays.asList(
            IProblem.UndefinedMethod,
            IProblem.UndefinedField,
            IProblem.ParameterMismatch,
            IProblem.UndefinedConstructor,
            IProblem.NotVisibleConstructor);

    private final Library library;
    private final BrickTarget target;
    private final List<ICompilationUnit> sources = new ArrayList<>();
    private final List<EcjProblem> problems = new ArrayList<>();
    private final Map<String, byte[]> classes = new LinkedHashMap<>();
    private final List<String> mainClasses = new ArrayList<>();
    private final Map<String, String> texts = new HashMap<>();
    private final Set<String> gaps = new HashSet<>();
    private CheckingCompiler compiler;
    private int characters;
    private int typeCount;

    /** @param library the class library of {@code target} */
    public EcjCompiler(Library library, BrickTarget target) {
        this.library = library;
        this.target = target;
    }

    /** @param path the source's path, with slashes; a public class in it must have the name of the file */
    public void addSource(String path, String text) {
        characters = Math.min(characters, SOURCE_CHARACTERS) + Math.min(text.length(), SOURCE_CHARACTERS + 1);
        if (characters > SOURCE_CHARACTERS || sources.size() == SOURCES) {
            problems.add(
                EcjProblem.of(path, BrickProblem.SOURCE_TOO_LONG, 0, 0, Integer.toString(SOURCE_CHARACTERS)));
            return;
        }
        SourceBounds bounds = new SourceBounds(path, text, typeCount, target.copiesFinally());
        typeCount = bounds.typeCount();
        if (bounds.problem() != null) {
            problems.add(bounds.problem());
            return;
        }
        texts.put(path, text);
        sources.add(new SourceUnit(path, text));
    }

    /**
     * Refuses each use of a class or member of the library.
     *
     * @param key the class's internal name, such as {@code java/lang/StringBuilder}; for a member, that of the class
     *     through which a program names it, a dot, and name and descriptor, such as
     *     {@code java/util/Stack.search(Ljava/lang/Object;)I} or {@code josx/platform/rcx/Sensor.RAW_VALUE:I}
     */
    public void addGap(String key) {
        gaps.add(key);
    }

    /** Compiles the sources added so far; call it only once. It throws nothing, whatever the sources contain. */
    public EcjResult compile() {
        boolean crashed = false;
        if (problems.isEmpty()) {
            WorkBudget.begin();
            try {
                compiler = new CheckingCompiler(
                        library.environment(), options(), target, this::take, gaps, problems);
                compiler.compile(sources.toArray(new ICompilationUnit[0]));
                crashed = compiler.crashed();
            } catch (RuntimeException | Error failure) {
                crashed = true;
            } finally {
                WorkBudget.end();
            }
            if (WorkBudget.exceeded() && !hasErrors()) {
                problems.add(WorkBudget.problem(new String(sources.get(0).getFileName())));
            }
        }
        return new EcjResult(classes, mainClasses, problems, crashed);
    }

    private boolean hasErrors() {
        for (EcjProblem problem : problems) {
            if (problem.error()) {
                return true;
            }
        }
        return false;
    }

    private void take(CompilationResult result) {
        CategorizedProblem[] found = result.getAllProblems();
        if (found != null) {
            for (CategorizedProblem problem : found) {
                problems.add(described(problem));
            }
        }
        if (result.hasErrors()) {
            return;
        }
        for (ClassFile file : result.getClassFiles()) {
            String name = new String(file.fileName());
            byte[] bytes = file.getBytes();
            classes.put(name, bytes);
            if (hasMain(name, bytes)) {
                mainClasses.add(name);
            }
        }
    }

    private EcjProblem described(CategorizedProblem problem) {
        String path = new String(problem.getOriginatingFileName());
        List<String> arguments = problem.getArguments() == null
            ? Collections.emptyList() : Arrays.asList(problem.getArguments());
        return new EcjProblem(
                path,
                problem.getID() & IProblem.IgnoreCategoriesMask,
                problem.isError(),
                (problem.getID() & IProblem.Syntax) != 0,
                problem.getSourceStart(),
                problem.getSourceEnd() + 1,
                problem.getMessage(),
                arguments,
                members(path, problem, arguments));
    }

    private List<String> members(String path, CategorizedProblem problem, List<String> arguments) {
        List<String> known = compiler.memberNames(path).at(problem.getSourceStart());
        if (known != null && NAMES_OF_MEMBERS.contains(problem.getID())) {
            return known;
        }
        if (problem.getID() == IProblem.UndefinedMethod) {
            return library.memberNames(withoutTypeArguments(arguments.get(0)));
        }
        if (problem.getID() == IProblem.UndefinedField) {
            return library.memberNames(nameBefore(texts.getOrDefault(path, ""), problem.getSourceStart()));
        }
        return Collections.emptyList();
    }

    private static String withoutTypeArguments(String type) {
        int start = type.indexOf('<');
        return start < 0 ? type : type.substring(0, start);
    }

    /** The name before the dot before {@code place}. */
    private static String nameBefore(String text, int place) {
        int end = Math.max(0, Math.min(place, text.length()) - 1);
        int start = end;
        while (start > 0 && Character.isJavaIdentifierPart(text.charAt(start - 1))) {
            start--;
        }
        return text.substring(start, end);
    }

    private static boolean hasMain(String name, byte[] bytes) {
        try {
            IBinaryMethod[] methods = new ClassFileReader(bytes, name.toCharArray()).getMethods();
            if (methods != null) {
                for (IBinaryMethod method : methods) {
                    int needed = ClassFileConstants.AccPublic | ClassFileConstants.AccStatic;
                    boolean open = (method.getModifiers() & needed) == needed;
                    if (open && new String(method.getSelector()).equals("main")
                            && new String(method.getMethodDescriptor()).equals("([Ljava/lang/String;)V")) {
                        return true;
                    }
                }
            }
            return false;
        } catch (ClassFormatException impossible) {
            throw new IllegalStateException("The compiler wrote a malformed class file.", impossible);
        }
    }

    private CompilerOptions options() {
        CompilerOptions options = new CompilerOptions();
        Map<String, String> settings = new HashMap<>();
        for (Map.Entry<String, String> standard : options.getMap().entrySet()) {
            boolean warns = CompilerOptions.WARNING.equals(standard.getValue());
            settings.put(standard.getKey(), warns ? CompilerOptions.IGNORE : standard.getValue());
        }
        target.addTo(settings);
        for (String attribute : DEBUGGING) {
            settings.put(attribute, CompilerOptions.GENERATE);
        }
        // Debuggers also show variables that are never read.
        settings.put(CompilerOptions.OPTION_PreserveUnusedLocal, CompilerOptions.PRESERVE);
        for (String warning : WARNINGS) {
            settings.put(warning, CompilerOptions.WARNING);
        }
        options.set(settings);
        return options;
    }
}
