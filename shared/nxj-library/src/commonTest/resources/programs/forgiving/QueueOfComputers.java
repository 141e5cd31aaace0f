import java.util.NoSuchElementException;
import java.util.Queue;
import java.util.Random;
import java.util.StringTokenizer;

// only here
public class QueueOfComputers {
    public static void main(String[] arguments) {
        Queue<String> queue = new Queue<String>();
        queue.offer("first");
        queue.offer("second");
        System.out.println(queue.element() + " " + queue.poll() + " " + queue.remove() + " " + queue.poll()); // expect first first second null
        try {
            queue.remove();
        } catch (NoSuchElementException wrong) {
            System.out.println("empty"); // expect empty
        }
        StringTokenizer signs = new StringTokenizer("1+2+3", "+", true);
        System.out.println(signs.countTokens()); // expect 5
        String words = "";
        while (signs.hasMoreTokens()) words += signs.nextToken() + " ";
        System.out.println(words.trim()); // expect 1 + 2 + 3
        StringTokenizer mixed = new StringTokenizer("a b=c", " ");
        System.out.println(mixed.nextToken() + " " + mixed.nextToken("=") + " " + mixed.nextToken()); // expect a b c
        Random random = new Random(1);
        int first = random.nextInt();
        random.setSeed(1);
        System.out.println(first == random.nextInt()); // expect true
        byte[] bytes = new byte[3];
        random.nextBytes(bytes);
        System.out.println(bytes[0] != 0 || bytes[1] != 0 || bytes[2] != 0); // expect true
    }
}
