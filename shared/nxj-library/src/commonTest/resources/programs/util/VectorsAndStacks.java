import java.util.EmptyStackException;
import java.util.Enumeration;
import java.util.Stack;
import java.util.Vector;

public class VectorsAndStacks {
    public static void main(String[] arguments) {
        Vector<String> vector = new Vector<String>();
        vector.addElement("a");
        vector.add("b");
        vector.insertElementAt("c", 0);
        System.out.println(vector + " " + vector.elementAt(0) + " " + vector.firstElement() + " " + vector.lastElement()); // expect [c, a, b] c c b
        vector.removeElementAt(1);
        vector.setElementAt("z", 0);
        System.out.println(vector.size() + " " + vector.contains("b") + " " + vector.indexOf("q")); // expect 2 true -1
        for (Enumeration<String> all = vector.elements(); all.hasMoreElements();) System.out.println(all.nextElement()); // expect z
        // expect b
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
