import java.util.EmptyQueueException;
import java.util.Queue;
import josx.platform.rcx.LCD;

public class Queues {
    public static void main(String[] arguments) {
        Queue queue = new Queue();
        LCD.showNumber(queue.empty() ? 1 : 0); // shows: 1
        queue.push("one");
        queue.push("seven");
        LCD.showNumber(((String) queue.peek()).length()); // shows: 3
        LCD.showNumber(((String) queue.pop()).length()); // shows: 3
        LCD.showNumber(((String) queue.pop()).length()); // shows: 5
        try {
            queue.peek();
        } catch (EmptyQueueException empty) {
            LCD.showNumber(queue.size()); // shows: 0
        }
    }
}
