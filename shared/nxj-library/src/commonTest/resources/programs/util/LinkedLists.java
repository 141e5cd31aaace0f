import java.util.LinkedList;
import java.util.NoSuchElementException;
import java.util.Queue;

public class LinkedLists {
    public static void main(String[] arguments) {
        LinkedList<Integer> list = new LinkedList<Integer>();
        for (int i = 1; i <= 5; i++) {
            list.addFirst(i);
            list.addLast(-i);
        }
        System.out.println(list); // expect [5, 4, 3, 2, 1, -1, -2, -3, -4, -5]
        System.out.println(list.getFirst() + " " + list.getLast() + " " + list.get(3)); // expect 5 -5 2
        System.out.println(list.removeFirst() + " " + list.removeLast() + " " + list.size()); // expect 5 -5 8
        list.add(2, 99);
        list.remove(Integer.valueOf(1));
        System.out.println(list); // expect [4, 3, 99, 2, -1, -2, -3, -4]
        Queue<String> queue = new LinkedList<String>();
        queue.offer("first");
        queue.offer("second");
        System.out.println(queue.peek() + " " + queue.poll() + " " + queue.poll() + " " + queue.poll()); // expect first first second null
        try {
            queue.remove();
        } catch (NoSuchElementException wrong) {
            System.out.println("empty"); // expect empty
        }
    }
}
