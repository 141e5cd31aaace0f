import java.util.ArrayList;
import java.util.ConcurrentModificationException;
import java.util.Iterator;
import java.util.List;
import java.util.ListIterator;

public class ArrayLists {
    public static void main(String[] arguments) {
        List<String> words = new ArrayList<String>();
        words.add("one");
        words.add("three");
        words.add(1, "two");
        System.out.println(words + " " + words.size()); // expect [one, two, three] 3
        System.out.println(words.get(2) + " " + words.indexOf("two") + " " + words.contains("four")); // expect three 1 false
        words.set(0, "zero");
        System.out.println(words.remove(1) + " " + words.remove("none") + " " + words); // expect two false [zero, three]
        ArrayList<Integer> numbers = new ArrayList<Integer>();
        for (int i = 0; i < 30; i++) numbers.add(i * 7 % 11);
        int sum = 0;
        for (int number : numbers) sum += number;
        System.out.println(sum); // expect 152
        for (Iterator<Integer> each = numbers.iterator(); each.hasNext();) {
            if (each.next() % 2 == 0) each.remove();
        }
        System.out.println(numbers); // expect [7, 3, 9, 5, 1, 7, 3, 9, 5, 1, 7, 3, 9, 5]
        numbers.remove(0);
        numbers.remove(Integer.valueOf(3));
        System.out.println(numbers); // expect [9, 5, 1, 7, 3, 9, 5, 1, 7, 3, 9, 5]
        ListIterator<Integer> walk = numbers.listIterator();
        while (walk.hasNext()) walk.set(walk.next() * 10);
        System.out.println(walk.previous() + " " + walk.previousIndex()); // expect 50 10
        List<Object> mixed = new ArrayList<Object>(words);
        mixed.addAll(numbers);
        mixed.add(null);
        System.out.println(mixed.size() + " " + mixed.indexOf(null) + " " + mixed.lastIndexOf(70)); // expect 15 14 10
        System.out.println(new ArrayList<String>(words).equals(words) + " " + words.hashCode()); // expect true 226131895
        Integer[] array = numbers.toArray(new Integer[numbers.size()]);
        System.out.println(array.length + " " + array[0]); // expect 12 90
        try {
            for (String word : words) words.add(word);
        } catch (ConcurrentModificationException wrong) {
            System.out.println("changed"); // expect changed
        }
        try {
            words.get(10);
        } catch (IndexOutOfBoundsException wrong) {
            System.out.println("outside"); // expect outside
        }
        words.clear();
        System.out.println(words.isEmpty() + " " + words); // expect true []
    }
}
