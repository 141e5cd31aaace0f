import josx.platform.rcx.LCD;

public class ErrorsWithoutMessages {
    public static void main(String[] arguments) {
        Throwable[] problems = {
            new Throwable(), new Error(), new NoClassDefFoundError(), new NoSuchMethodError(), new OutOfMemoryError(),
            new StackOverflowError(), new ThreadDeath(),
        };
        for (int index = 0; index < problems.length; index++) {
            if (problems[index].getMessage() != null || problems[index].toString().length() != 0) LCD.showNumber(index);
        }
        LCD.showNumber(problems.length); // shows: 7
    }
}
