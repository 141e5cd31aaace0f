import java.io.IOException;
import java.net.MalformedURLException;
import java.util.EmptyQueueException;
import java.util.EmptyStackException;
import josx.platform.rcx.LCD;
import josx.robotics.StopException;

public class ErrorsWithoutMessages {
    public static void main(String[] arguments) {
        Throwable[] problems = {
            new Throwable(), new Error(), new NoClassDefFoundError(), new NoSuchMethodError(), new OutOfMemoryError(),
            new StackOverflowError(), new ThreadDeath(), new Exception(), new ClassNotFoundException(), new InterruptedException(),
            new IOException(), new StopException(), new RuntimeException(), new ArithmeticException(), new ArrayIndexOutOfBoundsException(),
            new ClassCastException(), new IllegalArgumentException(), new IllegalMonitorStateException(), new IllegalStateException(),
            new NullPointerException(), new EmptyQueueException(), new EmptyStackException(),
            new MalformedURLException(),
        };
        for (int index = 0; index < problems.length; index++) {
            if (problems[index].getMessage() != null || problems[index].toString().length() != 0) LCD.showNumber(index);
        }
        LCD.showNumber(problems.length); // shows: 23
    }
}
