import java.util.EmptyQueueException;
import java.util.Queue;
import java.util.Vector;

// only here
public class QueueIsAClass {
    public static void main(String[] arguments) {
        Queue<String> queue = new Queue<String>();
        System.out.println(queue.empty()); // expect true
        System.out.println(queue.push("first") + " " + queue.push("second")); // expect first second
        System.out.println(queue.peek() + " " + queue.pop() + " " + queue.pop() + " " + queue.empty()); // expect first first second true
        try {
            queue.pop();
        } catch (EmptyQueueException wrong) {
            System.out.println(wrong.getMessage()); // expect null
        }
        try {
            queue.peek();
        } catch (EmptyQueueException wrong) {
            System.out.println("empty"); // expect empty
        }
        queue.push("a");
        queue.addElement("b");
        Vector<String> vector = queue;
        System.out.println(vector + " " + vector.size()); // expect [a, b] 2
    }
}
