import java.util.EmptyStackException;
import java.util.Enumeration;
import java.util.Stack;
import java.util.Vector;

public class VectorsAndStacks {
    public static void main(String[] arguments) {
        Vector<String> vector = new Vector<String>();
        vector.addElement("a");
        vector.addElement("b");
        vector.insertElementAt("c", 0);
        System.out.println(vector + " " + vector.elementAt(0) + " " + vector.elementAt(vector.size() - 1)); // expect [c, a, b] c b
        vector.removeElementAt(1);
        vector.setElementAt("z", 0);
        System.out.println(vector.size() + " " + vector.indexOf("b") + " " + vector.indexOf("q")); // expect 2 1 -1
        for (Enumeration<String> all = vector.elements(); all.hasMoreElements();) System.out.println(all.nextElement()); // expect z
        // expect b
        System.out.println(vector.removeElement("z") + " " + vector.removeElement("z") + " " + vector); // expect true false [b]
        vector.setSize(3);
        System.out.println(vector + " " + vector.lastIndexOf(null) + " " + vector.isEmpty()); // expect [b, null, null] 2 false
        Object[] copy = vector.toArray();
        System.out.println(copy.length + " " + copy[0]); // expect 3 b
        try {
            vector.setElementAt("x", 3);
        } catch (ArrayIndexOutOfBoundsException wrong) {
            System.out.println("no such place"); // expect no such place
        }
        Stack<Integer> stack = new Stack<Integer>();
        for (int i = 0; i < 4; i++) stack.push(i * i);
        System.out.println(stack.peek() + " " + stack.pop() + " " + stack.pop() + " " + stack.size()); // expect 9 9 4 2
        System.out.println(stack.search(0) + " " + stack.empty()); // expect 2 false
        stack.clear();
        try {
            stack.pop();
        } catch (EmptyStackException wrong) {
            System.out.println("empty"); // expect empty
        }
    }
}
