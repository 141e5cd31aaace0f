import java.util.LinkedList;
import java.util.NoSuchElementException;
import java.util.Vector;

public class ListsOfComputers {
    public static void main(String[] arguments) {
        LinkedList<Integer> list = new LinkedList<Integer>();
        for (int i = 1; i <= 3; i++) {
            list.addFirst(i);
            list.addLast(-i);
        }
        System.out.println(list + " " + list.getFirst() + " " + list.getLast()); // expect [3, 2, 1, -1, -2, -3] 3 -3
        System.out.println(list.removeFirst() + " " + list.removeLast() + " " + list.remove()); // expect 3 -3 2
        System.out.println(list.offer(7) + " " + list.peek() + " " + list.element() + " " + list.poll()); // expect true 1 1 1
        list.clear();
        System.out.println(list.poll() + " " + list.peek()); // expect null null
        try {
            list.getFirst();
        } catch (NoSuchElementException wrong) {
            System.out.println("empty"); // expect empty
        }
        Vector<String> vector = new Vector<String>();
        vector.add("b");
        vector.add(0, "a");
        System.out.println(vector.get(1) + vector.firstElement() + vector.lastElement() + vector.set(1, "c")); // expect babb
        System.out.println(vector.contains("a") + " " + vector.remove("a") + " " + vector.remove(0) + " " + vector); // expect true true c []
        vector.add("x");
        String[] copy = new String[2];
        vector.copyInto(copy);
        System.out.println(copy[0] + copy[1] + new Vector<Integer>(list)); // expect xnull[]
    }
}
